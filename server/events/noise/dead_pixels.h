// Dead pixels: they send nothing.
#pragma once

#include <cstdint>
#include <vector>

#include "events/noise/pixel_choice.h"
#include "saccade/wire/event.h"

namespace saccade {

class DeadPixels {
 public:
  DeadPixels(double fraction, std::uint64_t seed, int width, int height)
      : width_(width), dead_(static_cast<std::size_t>(width) * height) {
    const std::uint64_t key = noiseKey(seed, NoiseNumbers::kDeadPixels);
    for (std::uint32_t pixel = 0; pixel < dead_.size(); ++pixel)
      dead_[pixel] = isChosen(key, pixel, fraction);
  }

  // Removes their events.
  void remove(Events& events) const {
    std::erase_if(events,
                  [&](const Event& e) { return dead_[static_cast<std::size_t>(e.y) * width_ + e.x]; });
  }

 private:
  int width_;
  std::vector<bool> dead_;
};

}  // namespace saccade
