// The cost of tracing, and how far it is from its rays:
//   build/dev/bin/trace_speed [SCENE...]
// Prints CPU milliseconds per frame of one thread, the best of some rounds in turn, and their ratios. It
// compares the plain path tracer, one ray at a time, with the stages for both sets of instructions. Further
// columns are time inside Embree, rays per pixel, how full packets are, and two threads against one.
#include <cstdio>
#include <map>

#include "base/instruction_set.h"
#include "eval/bench/open_scene.h"
#include "render/one_ray_tracer.h"
#include "render/primary/blocks.h"
#include "render/renderer.h"

namespace saccade {
namespace {

constexpr int kWidth = 346, kHeight = 260, kBounces = 3, kRounds = 7;
const SeedPlan kSeeds = SeedPlan::correlated(1, 21, 2);

struct View {
  std::shared_ptr<const RenderScene> scene;
  PosedScene posed;
  Camera now, prev;

  PixelContext context() const { return {{posed, now}, {posed, prev}}; }
};

View open(const std::string& name) {
  auto scene = eval::openScene(name);
  FeedConfig feed;
  feed.camera = pinhole(scene->description().fov_x_deg, kWidth, kHeight);
  const Trajectory path = eval::openTrajectory(name, "right", *scene, feed);
  const auto at = [&](FrameIndex t) {
    return Camera(path.at(frameTime(t, feed.frame_rate_hz)), feed.camera);
  };
  return {scene, PosedScene(scene), at(21), at(20)};
}

std::chrono::nanoseconds renderOneRayAtATime(const View& s, const PoolHandle& pool, Frame& out) {
  const PixelContext view = s.context();
  return withKernel(s.scene->shading(), [&]<Shading S>() {
    return pool.forEachTile(kWidth, kHeight, 32, [&](Tile tile) {
      forEachPixel(tile, [&](int x, int y) {
        const Vec2 point{static_cast<float>(x), static_cast<float>(y)};
        PrimaryHit hit;
        tracePrimaries<S>(view, {&point, 1}, {&hit, 1});
        writeFeatures(hit, s.now, s.prev, x, y, out.g);
        const auto pixel = static_cast<std::uint32_t>(y * kWidth + x);
        const auto pass = [&](std::uint64_t seed) {
          if (!hit.valid) return 0.f;
          return test::traceOneRay<S, 3>({s.posed, kBounces, {}}, hit.start, PathSampler(seed, pixel, 0))
              .luminance();
        };
        out.samples.I1.at(x, y) = pass(kSeeds.seed1), out.samples.I2.at(x, y) = pass(kSeeds.seed2);
      });
    });
  });
}

class Best {
 public:
  void add(const std::string& name, std::chrono::nanoseconds time) {
    const double ms = std::chrono::duration<double, std::milli>(time).count();
    const auto [at, is_new] = ms_.try_emplace(name, ms);
    if (!is_new) at->second = std::min(at->second, ms);
  }
  double operator[](const std::string& name) const { return ms_.at(name); }

 private:
  std::map<std::string, double> ms_;
};

void measure(const std::string& name) {
  TilePool one(1), two(2);
  Frame frame(kWidth, kHeight);
  std::map<std::string, View> scenes;
  std::vector<std::string> sets{"avx2"};
  if (instructionSet() == InstructionSet::kAvx512) sets.push_back("avx512");
  for (const std::string& set : sets) {
    useInstructionSet(set);
    scenes.emplace(set, open(name));
  }
  Best best;
  PacketCounts scene, parts;  // of all shapes; of lamps, and of panes and masks alone
  for (int round = 0; round < kRounds; ++round) {
    for (const std::string& set : sets) {
      useInstructionSet(set);
      const View& s = scenes.at(set);
      Renderer renderer({kBounces, 3});
      best.add(set, renderer.render(s.context(), kSeeds, one, frame));
      best.add(set + ", two threads", renderer.render(s.context(), kSeeds, two, frame));
      scene = parts = {};
      s.scene->geometry().count(&scene), s.scene->emitters().count(&parts), s.scene->straight().count(&parts);
      renderer.render(s.context(), kSeeds, one, frame);
      for (const EmbreeScene* of : {&s.scene->geometry(), &s.scene->emitters(), &s.scene->straight()})
        of->count(nullptr);
      best.add(set + ", in Embree", scene.time + parts.time);
    }
    best.add("one ray at a time", renderOneRayAtATime(scenes.at(sets.back()), one, frame));
  }
  for (const std::string& set : sets)
    std::printf(
        "%-16s %-8s %8.1f %8.1f %8.2f %8.1f %8.2f %8.2f %10.2f %8.2f\n", eval::sceneName(name).c_str(),
        set.c_str(), best["one ray at a time"], best[set], best["one ray at a time"] / best[set],
        best[set + ", in Embree"], best[set] / best[set + ", in Embree"],
        static_cast<double>(scene.rays + parts.rays) / static_cast<double>(scene.lanes + parts.lanes),
        static_cast<double>(scene.rays) / (kWidth * kHeight), best[set + ", two threads"] / best[set]);
}

}  // namespace
}  // namespace saccade

int main(int argc, char** argv) {
  std::vector<std::string> names(argv + 1, argv + argc);
  if (names.empty()) names = {"cornell-box", "cornell-bunny"};
  std::printf("%-16s %-8s %8s %8s %8s %8s %8s %8s %10s %8s\n", "scene", "set", "one ray", "stages", "ratio",
              "Embree", "/ Embree", "filled", "rays/pixel", "2 / 1");
  try {
    for (const std::string& name : names) saccade::measure(name);
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "trace_speed: %s\n", fault.what());
    return 1;
  }
}
