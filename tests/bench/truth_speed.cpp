// The cost of truth channels:
//   build/dev/bin/truth_speed [SCENE [TRAJECTORY]]
// Renders some frames with the default method, and takes the samples of each channel. Prints CPU milliseconds
// per frame of one thread, without packets, and their share of the frame. A channel's time is that of the
// best of some rounds at each frame, on average over the frames.
#include <algorithm>
#include <cstdio>
#include <limits>

#include "base/thread_time.h"
#include "bench/recording.h"
#include "truth/truth_source.h"

namespace saccade {
namespace {

constexpr int kWarmUp = 8, kFrames = 16, kRounds = 7;

// A channel, and equal sources of it that see each frame one after the other.
struct Channel {
  std::string name;
  std::vector<std::unique_ptr<TruthSource>> rounds;
  double ms = 0;  // of all frames
};

std::vector<Channel> channels(const FeedConfig& feed) {
  std::vector<Channel> list;
  for (const TruthChannelInfo& info : truthTable()) {
    Channel& channel = list.emplace_back(Channel{info.name, {}});
    for (int round = 0; round < kRounds; ++round) {
      channel.rounds.push_back(info.make({.name = info.name,
                                          .frames = FrameSelection(),
                                          .width = feed.camera.width,
                                          .height = feed.camera.height}));
    }
  }
  return list;
}

double sampleMs(const FeedInterval& interval, TruthSource& source) {
  const auto began = threadCpuTime();
  source.sample(interval);
  return 1e3 * seconds(threadCpuTime() - began);
}

void sampleAll(const FeedInterval& interval, bool counts, std::vector<Channel>& list) {
  for (Channel& channel : list) {
    double best = std::numeric_limits<double>::infinity();
    for (const auto& source : channel.rounds) best = std::min(best, sampleMs(interval, *source));
    if (counts) channel.ms += best;
  }
}

void measure(const std::string& scene, const std::string& trajectory) {
  FeedConfig config;
  TilePool pool(1);
  const auto feed = openFeed(scene, trajectory, config, pool);
  std::vector<Channel> list = channels(config);
  std::vector<double> times;
  for (int i = 0; i < kWarmUp + kFrames; ++i) {
    feed->step(pool);
    sampleAll(feed->interval(), i >= kWarmUp, list);
    if (i >= kWarmUp) times.push_back(1e3 * seconds(feed->lastTimes().total()));
  }
  const double frame_ms = quantile(times, 0.5);
  std::printf("%s, %s, %d x %d: a frame takes %.1f ms\n", scene.c_str(), trajectory.c_str(),
              config.camera.width, config.camera.height, frame_ms);
  std::printf("%-14s %10s %10s\n", "channel", "ms/frame", "of it, %");
  for (const Channel& channel : list) {
    const double ms = channel.ms / kFrames;
    std::printf("%-14s %10.3f %10.2f\n", channel.name.c_str(), ms, 100 * ms / frame_ms);
  }
}

}  // namespace
}  // namespace saccade

int main(int argc, char** argv) {
  try {
    saccade::measure(argc > 1 ? argv[1] : "cornell-bunny", argc > 2 ? argv[2] : "right");
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "truth_speed: %s\n", fault.what());
    return 1;
  }
}
