// Shows a stimulus to a sensor, without any renderer.
#pragma once

#include <functional>

#include "eval/sensor/stimuli.h"
#include "events/sensor_config.h"
#include "saccade/wire/event.h"

namespace saccade::eval {

// The sensor that is measured. All measurements see the same pixels: they share its seed.
struct SensorSetup {
  SensorConfig config;  // has no fault
  int width = 64, height = 64;

  int pixels() const { return width * height; }
  std::size_t pixelOf(const Event& e) const { return static_cast<std::size_t>(e.y) * width + e.x; }
};

// The sensor's readout is taken as infinitely fast: its load depends on how many pixels answer at once.
// Calls `take` with each event that a new sensor sends, interval by interval.
void runSensor(const SensorSetup& setup, const Stimulus& stimulus,
               const std::function<void(const Event&)>& take);

}  // namespace saccade::eval
