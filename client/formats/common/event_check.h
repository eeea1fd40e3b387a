// Checks what no format ensures: times that do not run back, and pixels within the image.
#pragma once

#include "client/formats/common/reader.h"

namespace saccade::client {

class EventCheck {
 public:
  // `path` for errors. `mends`: whether the command has --sort and --crop, which they then name.
  EventCheck(const std::string& path, const ImageSize& size, bool mends = false)
      : path_(path), size_(size), mends_(mends) {}

  void check(const Events& events);  // throws FileFault with the number of the event at fault

 private:
  [[noreturn]] void fail(const Event& event, std::uint64_t number) const;

  const std::string path_;
  const ImageSize size_;
  const bool mends_;
  std::uint64_t count_ = 0;  // events before this batch
  std::int64_t last_ns_ = INT64_MIN;
};

std::string textOfUs(std::int64_t ns);  // "3 us", rounded up

}  // namespace saccade::client
