// Leak that moves the level of a pixel: log brightness seems to rise steadily.
#pragma once

#include <optional>

#include "events/pieces.h"
#include "events/sensor_config.h"
#include "frame/image.h"

namespace saccade {

// Log brightness rises by level_leak_hz C+ per second and pixel, times the factor of rate_spread. On a still
// picture it makes ON events at that rate, which reset the pixel. So ON events come earlier, and OFF events
// later or not at all. [Nozaki and Delbruck 2017; v2e: leak_rate_hz]
class LevelLeak {
 public:
  LevelLeak(const SensorConfig& config, int width, int height);

  // Adds the rise over an interval of `length`, or over the last piece of each pixel. That begins at the
  // share `from` of the interval.
  void add(TimeNs length, ImageF& dL, const ImageF* from = nullptr) const;
  // Adds it to pieces of the interval, before its last ones.
  void add(TimeNs length, Pieces& pieces) const;

 private:
  float slope(int x, int y) const { return slopes_ ? slopes_->at(x, y) : slope_; }

  float slope_;                   // log units per second
  std::optional<ImageF> slopes_;  // of each pixel, where they differ
};

}  // namespace saccade
