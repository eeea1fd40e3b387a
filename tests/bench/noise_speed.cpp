// What the parts of sensor noise cost:
//   build/dev/bin/noise_speed
// Gives changes made up at random to sensors with one part of noise each. Prints the CPU time of a frame of
// 346 x 260 pixels at 500 Hz, of one thread, beyond that of the sensor without noise. It is the best of some
// rounds in turn.
#include <algorithm>
#include <cstdio>
#include <limits>
#include <random>
#include <vector>

#include "base/thread_time.h"
#include "events/noise/presets.h"
#include "events/sensor.h"

namespace saccade {
namespace {

constexpr int kWidth = 346, kHeight = 260, kFrames = 64, kRounds = 9;

struct Part {
  std::string name;
  NoiseConfig noise;
  double ms = std::numeric_limits<double>::infinity();
  double events = 0;  // of a frame
};

std::vector<Part> parts() {
  std::vector<Part> list = {{"no noise", {}},
                            {"mismatch", {.mismatch = 0.15}},
                            {"photoreceptor", {.photoreceptor_hz = 300}},
                            {"photoreceptor, follower", {.photoreceptor_hz = 300, .follower_hz = 1000}},
                            {"leak 0.1 Hz", {.leak_hz = 0.1}},
                            {"shot 5 Hz", {.shot_hz = 5}},
                            {"hot 0.1 %", {.hot_fraction = 1e-3}},
                            {"dead 0.1 %", {.dead_fraction = 1e-3}},
                            {"jitter", {.jitter_s = 1e-5}},
                            {"readout 12 Meps", {.readout_hz = 12e6}}};
  for (const SensorPreset& preset : sensorPresets()) list.push_back({"preset " + preset.name, preset.noise});
  return list;
}

// A tenth of the pixels change, by up to 0.4.
std::vector<IntensityChange> changes() {
  std::vector<IntensityChange> list;
  for (int i = 0; i < 4; ++i) list.emplace_back(kWidth, kHeight);
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(-0.4f, 0.4f);
  for (IntensityChange& change : list) {
    change.I_prev.fill(1), change.I_now.fill(1);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) change.dI.at(x, y) = random() % 10 == 0 ? uniform(random) : 0;
  }
  return list;
}

void measure(std::vector<IntensityChange>& changes, Part& part) {
  SensorConfig config;
  config.noise = part.noise;
  config.reconstruction = "direct";
  Sensor sensor(config, kWidth, kHeight);
  SensorOutput out;
  std::size_t events = 0;
  const auto began = threadCpuTime();
  for (int i = 1; i <= kFrames; ++i) {
    IntensityChange& change = changes[i % changes.size()];
    change.frame = i, change.t0 = frameTime(i - 1, 500), change.t1 = frameTime(i, 500);
    sensor.generate(change, out);
    events += out.events.size();
  }
  part.ms = std::min(part.ms, 1e3 * seconds(threadCpuTime() - began) / kFrames);
  part.events = static_cast<double>(events) / kFrames;
}

}  // namespace
}  // namespace saccade

int main() {
  using namespace saccade;
  std::vector<Part> list = parts();
  std::vector<IntensityChange> frames = changes();
  for (int round = 0; round < kRounds; ++round)
    for (Part& part : list) measure(frames, part);
  std::printf("%-24s %14s %12s\n", "part", "events/frame", "ms/frame");
  for (const Part& part : list) {
    const double base = &part == &list.front() ? 0 : list.front().ms;
    std::printf("%-24s %14.0f %12.3f\n", part.name.c_str(), part.events, part.ms - base);
  }
}
