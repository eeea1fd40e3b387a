// What all streams together may take of the machine.
#pragma once

#include <memory>
#include <mutex>

namespace saccade {

inline constexpr int kMaxStreams = 64;
inline constexpr long kMaxStreamBytes = 4L << 30;  // all streams together, as streamBytes() estimates

// About the memory of a stream that looks through a view of its own.
long streamBytes(int width, int height, int sensors);

class Budget {
 public:
  // A place for a stream of so many bytes; given back when the last copy goes. The budget must outlive it.
  // Throws Refusal naming the limit.
  std::shared_ptr<void> reserve(long bytes);

 private:
  std::mutex mutex_;
  int streams_ = 0;
  long bytes_ = 0;
};

}  // namespace saccade
