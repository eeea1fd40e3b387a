// The cost of sensors whose intervals have updates:
//   build/dev/bin/update_speed
// An interval is 1 px of motion. At each 1/16 of it 15 % of 346 x 260 pixels have an update. They are at
// edges of a contrast of 0.3, which pass in a sixteenth. For some sensors it prints the ms per interval with
// updates, without them, and of 16 whole frames with the same brightness. The last columns are the events per
// interval. Times are CPU times of one thread, the best of some rounds in turn.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "base/thread_time.h"
#include "events/noise/presets.h"
#include "events/sensor.h"

namespace saccade {
namespace {

constexpr int kWidth = 346, kHeight = 260, kParts = 16, kIntervals = 6, kRounds = 15;
constexpr TimeNs kLength{16'000'000};

// The 15 % are pixels of rows that an edge crosses; the edges of a row are 20 pixels apart.
bool moves(int x, int y) {
  return (x + 3 * y) % 20 < 3;
}

// An edge passes in a sixteenth at another time in each pixel, once in an interval, up and down in turn.
float intensity(int x, int y, double t) {
  if (!moves(x, y)) return 1 + 0.02f * static_cast<float>(std::sin(t + x));
  const int edge = (x * 5 + y * 3) % kParts;
  const double passed = std::clamp(std::fmod(t, 2) * kParts - edge, 0.0, 1.0) -
                        std::clamp((std::fmod(t, 2) - 1) * kParts - edge, 0.0, 1.0);
  return static_cast<float>(std::exp(0.3 * passed));
}

IntensityChange changeFrom(double t0, double t1, FrameIndex frame) {
  IntensityChange change(kWidth, kHeight);
  change.t0 = TimeNs(std::llround(t0 * 16)) * (kLength.count() / 16);
  change.t1 = TimeNs(std::llround(t1 * 16)) * (kLength.count() / 16);
  change.frame = frame;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      change.I_prev.at(x, y) = intensity(x, y, t0), change.I_now.at(x, y) = intensity(x, y, t1);
      change.dI.at(x, y) = change.I_now.at(x, y) - change.I_prev.at(x, y);
    }
  return change;
}

using Changes = std::vector<IntensityChange>;

struct Streams {
  Changes updated, plain, frames;
};

Streams makeStreams() {
  Streams all;
  for (FrameIndex i = 0; i < kIntervals; ++i) {
    const auto t0 = static_cast<double>(i);
    all.plain.push_back(changeFrom(t0, t0 + 1, i + 1));
    IntensityChange& change = all.updated.emplace_back(changeFrom(t0, t0 + 1, i + 1));
    for (int k = 1; k < kParts; ++k)
      for (int pixel = 0; pixel < kWidth * kHeight; ++pixel) {
        const int x = pixel % kWidth, y = pixel / kWidth;
        const float at = static_cast<float>(k) / kParts;
        if (moves(x, y))
          change.updates.push_back({static_cast<std::uint32_t>(pixel), at, intensity(x, y, t0 + at)});
      }
    for (FrameIndex k = 0; k < kParts; ++k)
      all.frames.push_back(changeFrom(t0 + static_cast<double>(k) / kParts,
                                      t0 + static_cast<double>(k + 1) / kParts, i * kParts + k + 1));
  }
  return all;
}

// CPU time of the second half of the intervals, per interval.
double measure(const SensorConfig& config, const Changes& changes, double& events) {
  Sensor sensor(config, kWidth, kHeight);
  SensorOutput out;
  events = 0;
  auto began = threadCpuTime();
  for (std::size_t i = 0; i < changes.size(); ++i) {
    if (i == changes.size() / 2) began = threadCpuTime(), events = 0;
    sensor.generate(changes[i], out);
    events += static_cast<double>(out.events.size());
  }
  events /= kIntervals / 2;
  return 1e3 * seconds(threadCpuTime() - began) / (kIntervals / 2);
}

struct Row {
  std::string name;
  SensorConfig config;
  std::array<double, 3> ms{}, events{};
};

std::vector<Row> rows() {
  const SensorConfig plain{.reconstruction = "direct"};
  std::vector<Row> list;
  const auto add = [&](const std::string& name) -> SensorConfig& {
    return list.emplace_back(Row{name, plain}).config;
  };
  add("direct");
  add("kalman").reconstruction = "kalman";
  add("refractory 0.5 ms").refractory = TimeNs(500'000);
  add("low pass 300 Hz").noise.photoreceptor_hz = 300;
  add("mismatch").noise.mismatch = 0.15;
  add("labels").labels = true;
  add("probabilistic").model = "probabilistic";
  SensorConfig& davis = add("davis346");
  davis.noise = findPreset("davis346")->noise, davis.refractory = TimeNs(500'000);
  davis.reconstruction = "kalman";
  for (Row& row : list) row.ms.fill(std::numeric_limits<double>::infinity());
  return list;
}

void measureAll() {
  const Streams streams = makeStreams();
  const std::array<const Changes*, 3> of{&streams.updated, &streams.plain, &streams.frames};
  std::vector<Row> list = rows();
  for (int round = 0; round < kRounds; ++round)
    for (Row& row : list)
      for (std::size_t i = 0; i < of.size(); ++i)
        row.ms[i] = std::min(row.ms[i], measure(row.config, *of[i], row.events[i]));
  std::printf("%zu updates per interval\n", streams.updated.front().updates.size());
  std::printf("%-20s %10s %10s %10s %10s %10s\n", "sensor", "updates", "without", "16 frames", "events",
              "of frames");
  for (const Row& row : list)
    std::printf("%-20s %10.3f %10.3f %10.3f %10.0f %10.0f\n", row.name.c_str(), row.ms[0], row.ms[1],
                row.ms[2], row.events[0], row.events[2]);
}

}  // namespace
}  // namespace saccade

int main() {
  saccade::measureAll();
}
