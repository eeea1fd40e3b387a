// The consecutive frames of a run as one sensor sees them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "eval/bench/bench.h"
#include "events/sensor_config.h"
#include "saccade/wire/event.h"

namespace saccade::eval {

// At least one frame, in order. The frames must outlive the sequence.
using ChangeSequence = std::vector<const IntensityChange*>;
ChangeSequence sequenceOf(const BenchRun& run);
ChangeSequence sequenceOf(const std::vector<Truth>& truth);

// Runs each method with each spp, with progress on stderr. Throws Interrupted.
using RunUse = std::function<void(const std::string& method, int spp, const ChangeSequence& run)>;
void forEachRun(const Bench& bench, const std::vector<std::string>& methods, const std::vector<int>& spp,
                const RunUse& use);

// The brightness that a sensor's reconstruction gives each pixel [E (22)].
struct BrightnessSequence {
  ImageF L_start;          // log(I_eps + I_prev) of the first frame
  std::vector<ImageF> dL;  // of each frame

  // L_0, L_1, ... of a pixel: one value more than there are frames.
  std::vector<double> at(int x, int y) const;
};
BrightnessSequence brightnessOf(const ChangeSequence& changes, const SensorConfig& config);

// In time order.
Events eventsOf(const ChangeSequence& changes, const SensorConfig& config);

}  // namespace saccade::eval
