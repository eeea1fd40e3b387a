// The bounds of the events of an interval: those of each pixel, and those of all of them together.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "events/sensor_config.h"

namespace saccade {

class EventBounds {
 public:
  EventBounds(const SensorConfig& config, std::size_t pixels)
      : pixels_(pixels),
        max_events_(config.max_events_per_pixel_frame),
        max_all_(config.max_events_per_frame),
        room_(max_all_) {}

  // `once`: each pixel takes at most once in this interval.
  void begin(bool once) {
    suppressed_ = 0;
    room_ = max_all_;
    sent_.assign(once ? 0 : pixels_, 0);
  }

  // How many of the next `count` events of a pixel may be sent. The others count as suppressed.
  std::int64_t take(std::size_t pixel, std::int64_t count) {
    std::uint32_t* before = sent_.empty() ? nullptr : &sent_[pixel];
    const std::int64_t wanted = std::min(count, max_events_ - (before ? *before : 0));
    const auto sent = static_cast<std::int64_t>(std::min(static_cast<std::uint64_t>(wanted), room_));
    suppress(static_cast<std::uint64_t>(count - sent));
    room_ -= static_cast<std::uint64_t>(sent);
    if (before) *before += static_cast<std::uint32_t>(sent);
    return sent;
  }

  void suppress(std::uint64_t count) { suppressed_ += count; }
  std::uint64_t suppressed() const { return suppressed_; }  // since begin()

 private:
  std::size_t pixels_;
  std::int64_t max_events_;          // of a pixel
  std::uint64_t max_all_, room_;     // of all pixels; how many more of them this interval
  std::vector<std::uint32_t> sent_;  // events of this interval, by pixel; empty where pixels take once
  std::uint64_t suppressed_ = 0;
};

}  // namespace saccade
