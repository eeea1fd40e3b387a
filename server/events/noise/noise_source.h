// Noise events: those that a sensor makes beside the signal.
#pragma once

#include <memory>
#include <vector>

#include "events/sensor_config.h"
#include "frame/intensity_change.h"
#include "saccade/wire/event.h"

namespace saccade {

// Takes the events of an interval, as long as there is room.
class NoiseSink {
 public:
  NoiseSink(std::uint64_t room, Events& events) : room_(room), events_(events) {}

  void add(std::int64_t t_ns, std::uint32_t pixel, int width, std::uint8_t p) {
    if (room_ == 0) {
      ++withheld_;
      return;
    }
    --room_;
    events_.push_back({.t_ns = t_ns,
                       .x = static_cast<std::uint16_t>(pixel % width),
                       .y = static_cast<std::uint16_t>(pixel / width),
                       .p = p,
                       .source = kNoise});
  }
  std::uint64_t withheld() const { return withheld_; }

 private:
  static constexpr std::uint8_t kNoise = 1;  // v1::EVENT_SOURCE_NOISE
  std::uint64_t room_, withheld_ = 0;
  Events& events_;
};

// Its events depend on its settings, the seed and the intensity alone: never on the state of the pixels.
class NoiseSource {
 public:
  virtual ~NoiseSource() = default;
  // Adds the events of the interval of `change`, in time order. Takes time per event, not per pixel.
  virtual void generate(const IntensityChange& change, NoiseSink& sink) = 0;
};

// Those that are on: leak, shot noise, hot pixels.
std::vector<std::unique_ptr<NoiseSource>> makeNoiseSources(const SensorConfig& config, int width, int height);

}  // namespace saccade
