// The cost of sensors and their packets:
//   build/dev/bin/event_speed [SCENE [TRAJECTORY]]
// Renders some frames once with the default method. Gives them to sensors of each event model and
// reconstruction, at a coarse and a fine contrast threshold. Prints for each the events per pixel and frame,
// and million events per second and core, from the change of intensity to the packet. The last column is the
// cost of 64 such sensors and the frame, in frames. Times are CPU times of one thread, the best of some
// rounds in turn; that of the frame is a median.
#include <cstdio>
#include <limits>

#include "app/sequence/sensor_channel.h"
#include "bench/recording.h"
#include "events/event_model.h"
#include "events/reconstruction.h"

namespace saccade {
namespace {

constexpr int kWarmUp = 8, kFrames = 24, kRounds = 7, kSensors = 64;

struct Cost {
  std::uint64_t events = 0;
  double ms = std::numeric_limits<double>::infinity();  // of all frames
};

// One run of a new sensor over the frames.
void measure(const Recording& r, const SensorConfig& config, Cost& best) {
  const PacketSource source{.stream_id = "s",
                            .width = static_cast<std::uint32_t>(r.feed.camera.width),
                            .height = static_cast<std::uint32_t>(r.feed.camera.height)};
  SensorChannel channel(config, source, 0);
  const FeedInterval last = r.source->interval();
  std::chrono::nanoseconds time{0};
  for (const IntensityChange& change : r.changes) {
    channel.process({change, last.rendered}, false);
    time += channel.cost();
  }
  best.ms = std::min(best.ms, 1e3 * seconds(time));
  best.events = channel.items();
}

void measureAll(const std::string& scene, const std::string& trajectory) {
  const Recording r = recordChanges(scene, trajectory, kWarmUp, kFrames);
  std::printf("%s, %s, %d x %d: a frame takes %.1f ms\n", scene.c_str(), trajectory.c_str(),
              r.feed.camera.width, r.feed.camera.height, r.frame_ms);
  std::vector<SensorConfig> configs;
  for (const EventModelInfo& model : eventModelTable())
    for (const ReconstructionInfo& reconstruction : reconstructionTable())
      for (const double C : {0.2, 0.02}) {
        SensorConfig& config = configs.emplace_back();
        config.threshold = config.threshold_off = C;
        config.model = model.name, config.reconstruction = reconstruction.name;
      }
  std::vector<Cost> best(configs.size());
  for (int round = 0; round < kRounds; ++round)
    for (std::size_t i = 0; i < configs.size(); ++i) measure(r, configs[i], best[i]);

  std::printf("%-14s %-14s %5s %12s %9s %15s\n", "model", "reconstruction", "C", "events/pixel", "million/s",
              "frame with 64");
  for (std::size_t i = 0; i < configs.size(); ++i) {
    const SensorConfig& config = configs[i];
    const auto events = static_cast<double>(best[i].events);
    std::printf("%-14s %-14s %5.2f %12.3f %9.1f %15.2f\n", config.model.c_str(),
                config.reconstruction.c_str(), config.threshold,
                events / kFrames / (r.feed.camera.width * r.feed.camera.height), events / best[i].ms / 1e3,
                1 + kSensors * best[i].ms / kFrames / r.frame_ms);
  }
}

}  // namespace
}  // namespace saccade

int main(int argc, char** argv) {
  try {
    saccade::measureAll(argc > 1 ? argv[1] : "cornell-bunny", argc > 2 ? argv[2] : "truck:2px");
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "event_speed: %s\n", fault.what());
    return 1;
  }
}
