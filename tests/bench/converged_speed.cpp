// The cost of a frame whose light is known:
//   build/dev/bin/converged_speed [SCENE...]
// Bakes each scene for some frames, or takes the kept bake. Prints CPU milliseconds per frame of one thread.
// Columns are the primary rays alone, in packets, and each stage of the method that reads the bake, which it
// does while it traces. The last is the ratio of the whole to the rays. The best of some rounds in turn.
#include <cstdio>
#include <limits>

#include "base/default_cache.h"
#include "eval/bench/kept_bake.h"
#include "eval/bench/open_scene.h"
#include "methods/method_spec.h"
#include "render/primary/blocks.h"
#include "render/world/coherent_rays.h"

namespace saccade {
namespace {

constexpr int kWarmUp = 4, kFrames = 16, kRounds = 5, kTile = 32, kEdge = 4;
constexpr double kBakeError = 0.05;
const FrameIndex kAll = kWarmUp + kFrames;

void traceRays(const RenderScene& scene, const Camera& camera, Tile block) {
  std::array<Ray, kEdge * kEdge> rays;
  std::array<Hit, kEdge * kEdge> hits;
  std::size_t count = 0;
  forEachPixel(block, [&](int x, int y) {
    const Vec3 direction = camera.direction(static_cast<float>(x), static_cast<float>(y));
    rays[count++] = {camera.origin, direction, std::numeric_limits<float>::infinity()};
  });
  intersectCoherent(scene.geometry(), std::span(rays).first(count), std::span(hits).first(count));
}

std::chrono::nanoseconds tracePrimaryRays(const RenderScene& scene, const Camera& camera,
                                          const FeedConfig& view, const PoolHandle& pool) {
  return pool.forEachTile(view.camera.width, view.camera.height, kTile, [&](Tile tile) {
    for (int y = tile.y0; y < tile.y1; y += kEdge)
      for (int x = tile.x0; x < tile.x1; x += kEdge)
        traceRays(scene, camera, {x, y, std::min(x + kEdge, tile.x1), std::min(y + kEdge, tile.y1)});
  });
}

void measure(const std::string& name) {
  TilePool pool(2), one(1);
  FeedConfig config;
  config.method = "irradiance_cache";
  config.params = parseMethod(config.method).params;
  const auto scene = eval::openScene(name);
  config.camera = pinhole(scene->description().fov_x_deg, 346, 260);
  const Trajectory path = eval::openTrajectory(name, "right", *scene, config);
  const BakePlan plan = planBake(*scene, path, config, kAll, kBakeError);
  config.baked = eval::keptBake(scene, plan, defaultCache(), name, pool).light;

  double rays_ms = std::numeric_limits<double>::infinity();
  StageTimes best;
  best[Stage::kTrace] = std::chrono::hours(1);
  for (int round = 0; round < kRounds; ++round) {
    Feed feed(scene, path, config, one);
    for (FrameIndex t = 1; t <= kAll; ++t) {
      feed.step(one);
      if (t <= kWarmUp) continue;
      if (feed.lastTimes().total() < best.total()) best = feed.lastTimes();
      const Camera camera(path.at(frameTime(t, config.frame_rate_hz)), config.camera);
      rays_ms = std::min(rays_ms, 1e3 * seconds(tracePrimaryRays(*scene, camera, config, one)));
    }
  }
  std::printf("%-16s %8.2f", eval::sceneName(name).c_str(), rays_ms);
  for (const auto time : best.cpu) std::printf(" %8.2f", 1e3 * seconds(time));
  std::printf(" %8.2f %8.2f\n", 1e3 * seconds(best.total()), 1e3 * seconds(best.total()) / rays_ms);
}

}  // namespace
}  // namespace saccade

int main(int argc, char** argv) {
  std::vector<std::string> names(argv + 1, argv + argc);
  if (names.empty()) names = {"cornell-bunny", SACCADE_SOURCE_DIR "/tests/stability/scenes/sun_and_lamp.xml"};
  std::printf("%-16s %8s", "scene", "rays");
  for (const char* stage : saccade::kStageNames) std::printf(" %8s", stage);
  std::printf(" %8s %8s\n", "all", "/ rays");
  try {
    for (const std::string& name : names) saccade::measure(name);
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "converged_speed: %s\n", fault.what());
    return 1;
  }
}
