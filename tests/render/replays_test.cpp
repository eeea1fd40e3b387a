// Paths that are replayed in the world of the frame before.
#include <gtest/gtest.h>

#include "render/moving_room.h"
#include "render/renderer.h"

namespace saccade {
namespace {

using namespace test;

constexpr int kSize = 32;
constexpr std::uint32_t kPaths = 3;

// A frame into which a body of the room has moved, and the changes that replays tell.
struct ReplayedFrame {
  explicit ReplayedFrame(const std::string& name)
      : scene(withBodies({name})),
        now(scene, {standing(scene->description().bodies[0], kMoved)}),
        before(scene, {standing(scene->description().bodies[0])}),
        camera(scene->description().T_world_camera, pinhole(80, kSize, kSize)) {
    trace(view, renderer, frame);
    renderer.renderReplays(view, seeds, pool, frame);
    Renderer other{{2, 1}};
    trace(PixelContext{{before, camera}, {before, camera}}, other, frame_before);
  }
  void trace(const PixelContext& of, Renderer& by, Frame& out) {
    const SurfaceFrame next = by.renderSurfaces(of, pool, out);
    for (int y = 0; y < kSize; ++y)
      for (SurfacePoint& p : out.surfaces->row(y)) p.paths = kPaths;
    by.renderPaths(of.now, seeds, next, nullptr, pool);
  }

  // Whether the pixel of a point shows what stands, in both frames.
  bool stands(std::size_t i) const {
    const int x = frame.surfaces->columnOf(static_cast<std::uint32_t>(i));
    const int y = frame.surfaces->rowOf(static_cast<std::uint32_t>(i));
    return frame.g.body.at(x, y) == 0 && frame_before.g.body.at(x, y) == 0;
  }
  int touched(std::size_t i) const {
    int count = 0;
    for (std::uint32_t path = 0; path < kPaths; ++path) count += renderer.touchedPaths().has(i, path);
    return count;
  }

  std::shared_ptr<const RenderScene> scene;
  const PosedScene now, before;
  const Camera camera;
  const PixelContext view{{now, camera}, {before, camera}};
  const SeedPlan seeds = SeedPlan::independent(1, 1, kPaths);
  TilePool pool{2};
  Renderer renderer{{2, 1}};
  Frame frame{kSize, kSize, 1}, frame_before{kSize, kSize, 1};
};

// Of points that stand, another renderer traces all paths in the world of the frame before.
TEST(Replays, TellTheChangeOfEachPoint) {
  for (const std::string name : {"card", "ball"}) {
    const ReplayedFrame of(name);
    const SurfaceSamples &on = *of.frame.surfaces, &before = *of.frame_before.surfaces;
    int differ = 0;
    for (std::size_t i = 0; i < kSize * kSize; ++i) {
      if (!of.stands(i)) continue;
      const float change = on.light(i).residual - before.light(i).residual;
      EXPECT_NEAR(on.changes()[i], change, 1e-6) << name << i;
      differ += change != 0;
    }
    EXPECT_GT(differ, kSize) << name;
  }
}

// Others find the same in both worlds, so that they are not traced again.
TEST(Replays, AreOfPathsWhoseRaysFindOtherSurfaces) {
  for (const std::string name : {"card", "ball"}) {
    const ReplayedFrame of(name);
    int touched = 0, differ = 0;
    for (std::size_t i = 0; i < kSize * kSize; ++i) {
      if (!of.stands(i)) continue;
      touched += of.touched(i) > 0;
      differ += of.frame.surfaces->changes()[i] != 0;
    }
    EXPECT_GE(touched, differ) << name;
    EXPECT_LT(touched, 1.1 * differ) << name;
  }
}

TEST(Replays, AreOfAllPathsFromABodyThatMoves) {
  const ReplayedFrame of("card");
  int seen = 0;
  for (std::size_t i = 0; i < kSize * kSize; ++i) {
    const auto point = static_cast<std::uint32_t>(i);
    if (of.frame.g.body.at(of.frame.surfaces->columnOf(point), of.frame.surfaces->rowOf(point)) == 0)
      continue;
    ++seen;
    EXPECT_EQ(of.touched(i), int(kPaths)) << i;
  }
  EXPECT_GT(seen, 10);
}

TEST(Replays, AMovingLampTouchesAllPaths) {
  const ReplayedFrame of("lamp");
  for (std::size_t i = 0; i < kSize * kSize; ++i) EXPECT_EQ(of.touched(i), int(kPaths)) << i;
}

}  // namespace
}  // namespace saccade
