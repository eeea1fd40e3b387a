// What all streams together may take of the machine.
#pragma once

#include <memory>
#include <mutex>

namespace saccade {

inline constexpr int kMaxStreams = 64;
inline constexpr long kMaxOpenPixels = 16 << 20;  // of all views; a feed takes about 200 bytes for each

class Budget {
 public:
  // A place for a stream whose view has so many pixels; given back when the last copy goes. The budget must
  // outlive it. Throws Refusal naming the limit.
  std::shared_ptr<void> reserve(long pixels);

 private:
  std::mutex mutex_;
  int streams_ = 0;
  long pixels_ = 0;
};

}  // namespace saccade
