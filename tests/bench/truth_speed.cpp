// What truth channels cost:
//   build/dev/bin/truth_speed [SCENE [TRAJECTORY]]
// Renders some frames with the default method, and takes one sample of each channel from each. Prints CPU
// milliseconds per sample of one thread, without its packet, and those of the frame. The best of some rounds.
#include <cstdio>
#include <limits>

#include "base/thread_time.h"
#include "eval/bench/open_scene.h"
#include "methods/method_spec.h"
#include "truth/truth_source.h"

namespace saccade {
namespace {

constexpr int kFrames = 4, kRounds = 5;

double sampleMs(const TruthChannelInfo& info, const FeedConfig& feed, const FeedInterval& interval) {
  const auto source = info.make({.name = info.name,
                                 .frames = FrameSelection(),
                                 .width = feed.camera.width,
                                 .height = feed.camera.height});
  const auto began = threadCpuTime();
  const std::size_t samples = source->sample(interval).size();
  return 1e3 * seconds(threadCpuTime() - began) / static_cast<double>(samples);
}

void measure(const std::string& scene_name, const std::string& trajectory) {
  FeedConfig config;
  config.params = parseMethod(config.method).params;
  const auto scene = eval::openScene(scene_name);
  config.camera = pinhole(scene->description().fov_x_deg, 346, 260);
  TilePool pool(1);
  Feed feed(scene, eval::openTrajectory(scene_name, trajectory, *scene, config), config, pool);
  double frame_ms = std::numeric_limits<double>::infinity();
  std::vector<double> best(truthTable().size(), frame_ms);
  for (int frame = 0; frame < kFrames; ++frame) {
    feed.step(pool);
    frame_ms = std::min(frame_ms, 1e3 * seconds(feed.lastTimes().total()));
    for (int round = 0; round < kRounds; ++round)
      for (std::size_t i = 0; i < best.size(); ++i)
        best[i] = std::min(best[i], sampleMs(truthTable()[i], config, feed.interval()));
  }
  std::printf("%s %s, %dx%d, CPU ms\n", scene_name.c_str(), trajectory.c_str(), config.camera.width,
              config.camera.height);
  for (std::size_t i = 0; i < best.size(); ++i)
    std::printf("%-14s %8.3f\n", truthTable()[i].name.c_str(), best[i]);
  std::printf("%-14s %8.3f\n", "(the frame)", frame_ms);
}

}  // namespace
}  // namespace saccade

int main(int argc, char** argv) {
  try {
    saccade::measure(argc > 1 ? argv[1] : "cornell-bunny", argc > 2 ? argv[2] : "right");
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "%s\n", fault.what());
    return 1;
  }
}
