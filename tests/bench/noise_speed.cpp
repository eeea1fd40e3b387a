// The cost of the parts of sensor noise:
//   build/dev/bin/noise_speed [SCENE [TRAJECTORY]]
// Renders some frames once with the default method, and gives them to sensors with one part of noise each.
// Prints the CPU time per frame of 346 x 260 pixels, of one thread, beyond that of the sensor without noise.
// Beside it is its share of the frame. Each is the best of some rounds in turn.
#include <algorithm>
#include <cstdio>
#include <limits>
#include <vector>

#include "base/thread_time.h"
#include "bench/recording.h"
#include "events/noise/presets.h"
#include "events/sensor.h"

namespace saccade {
namespace {

constexpr int kWarmUp = 8, kFrames = 32, kRounds = 15;
constexpr int kFirstFrames = 4;  // of a sensor: it allocates

struct Part {
  std::string name;
  NoiseConfig noise;
  double ms = std::numeric_limits<double>::infinity();  // per frame
  double events = 0;                                    // of a frame
};

std::vector<Part> parts() {
  std::vector<Part> list = {{"no noise", {}},
                            {"mismatch", {.mismatch = 0.15}},
                            {"photoreceptor", {.photoreceptor_hz = 300}},
                            {"photoreceptor, follower", {.photoreceptor_hz = 300, .follower_hz = 1000}},
                            {"photoreceptor, asymmetry", {.photoreceptor_hz = 300, .asymmetry = 1}},
                            {"dark current 0.01", {.dark_luminance = 0.01}},
                            {"leak of the level 0.1 Hz", {.level_leak_hz = 0.1}},
                            {"Brownian motion 0.1 Hz", {.brownian_hz = 0.1}},
                            {"leak 0.1 Hz", {.leak_hz = 0.1}},
                            {"the same, spread", {.leak_hz = 0.1, .rate_spread = 0.5}},
                            {"shot 5 Hz", {.shot_hz = 5}},
                            {"hot 0.1 %", {.hot_fraction = 1e-3}},
                            {"dead 0.1 %", {.dead_fraction = 1e-3}},
                            {"jitter", {.jitter_s = 1e-5}},
                            {"readout 12 Meps", {.readout_hz = 12e6}}};
  for (const SensorPreset& preset : sensorPresets()) list.push_back({"preset " + preset.name, preset.noise});
  return list;
}

void measure(const Recording& r, Part& part) {
  SensorConfig config;
  config.noise = part.noise;
  if (part.noise.brownian_hz > 0) config.model = "stochastic";
  Sensor sensor(config, r.feed.camera.width, r.feed.camera.height);
  SensorOutput out;
  std::size_t events = 0;
  std::chrono::nanoseconds time{0};
  for (int i = 0; i < kFrames; ++i) {
    const auto began = threadCpuTime();
    sensor.generate(r.changes[i], out);
    if (i < kFirstFrames) continue;
    time += threadCpuTime() - began;
    events += out.events.size();
  }
  part.ms = std::min(part.ms, 1e3 * seconds(time) / (kFrames - kFirstFrames));
  part.events = static_cast<double>(events) / (kFrames - kFirstFrames);
}

void measureAll(const std::string& scene, const std::string& trajectory) {
  const Recording r = recordChanges(scene, trajectory, kWarmUp, kFrames);
  std::vector<Part> list = parts();
  for (int round = 0; round < kRounds; ++round)
    for (Part& part : list) measure(r, part);
  std::printf("%s, %s, %d x %d: a frame takes %.1f ms\n", scene.c_str(), trajectory.c_str(),
              r.feed.camera.width, r.feed.camera.height, r.frame_ms);
  std::printf("%-24s %14s %10s %10s\n", "part", "events/frame", "ms/frame", "of it, %");
  for (const Part& part : list) {
    const double ms = part.ms - (&part == &list.front() ? 0 : list.front().ms);
    std::printf("%-24s %14.0f %10.3f %10.2f\n", part.name.c_str(), part.events, ms, 100 * ms / r.frame_ms);
  }
}

}  // namespace
}  // namespace saccade

int main(int argc, char** argv) {
  try {
    saccade::measureAll(argc > 1 ? argv[1] : "cornell-bunny", argc > 2 ? argv[2] : "right");
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "noise_speed: %s\n", fault.what());
    return 1;
  }
}
