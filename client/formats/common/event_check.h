// Checks what no format ensures: times that do not run back, and pixels within the image.
#pragma once

#include "client/formats/common/reader.h"

namespace saccade::client {

class EventCheck {
 public:
  // `path` for errors.
  EventCheck(const std::string& path, const ImageSize& size) : path_(path), size_(size) {}

  void check(const Events& events);  // throws FileFault with the number of the event at fault

 private:
  [[noreturn]] void fail(const Event& event, std::uint64_t number) const;

  const std::string path_;
  const ImageSize size_;
  std::uint64_t count_ = 0;  // events before this batch
  std::int64_t last_ns_ = INT64_MIN;
};

}  // namespace saccade::client
