// Paths that are replayed in the world of the frame before.
#include <gtest/gtest.h>

#include "render/moving_room.h"
#include "render/renderer.h"

namespace saccade {
namespace {

using namespace test;

constexpr int kSize = 32;

// A frame into which a body of the room has moved, and its replays.
struct ReplayedFrame {
  explicit ReplayedFrame(const std::string& name)
      : scene(withBodies({name})),
        now(scene, {standing(scene->description().bodies[0], kMoved)}),
        before(scene, {standing(scene->description().bodies[0])}),
        camera(scene->description().T_world_camera, pinhole(80, kSize, kSize)) {
    const SurfaceFrame next = renderer.renderSurfaces(view, pool, frame);
    for (int y = 0; y < kSize; ++y)
      for (SurfacePoint& p : frame.surfaces->row(y)) p.paths = 2;
    renderer.renderPaths(view.now, seeds, next, nullptr, pool);
    replay();
  }
  void replay() { renderer.renderReplays(view, seeds, pool, frame); }
  int touched() const {
    int count = 0;
    for (int y = 0; y < kSize; ++y)
      for (const SurfacePoint& p : frame.surfaces->row(y)) count += p.touched;
    return count;
  }

  std::shared_ptr<const RenderScene> scene;
  const PosedScene now, before;
  const Camera camera;
  const PixelContext view{{now, camera}, {before, camera}};
  const SeedPlan seeds = SeedPlan::independent(1, 1, 2);
  TilePool pool{2};
  Renderer renderer{{2, 1}};
  Frame frame{kSize, kSize, 1};
};

// All are traced the second time.
TEST(Replays, PathsThatMeetNoPlaceOfABodyWouldFindTheSame) {
  for (const std::string name : {"card", "ball"}) {
    ReplayedFrame of(name);
    EXPECT_LT(of.touched(), kSize * kSize * 0.9) << name;
    const std::vector<SurfaceLight> first = of.frame.surfaces->replays();
    for (int y = 0; y < kSize; ++y)
      for (SurfacePoint& p : of.frame.surfaces->row(y)) p.touched = true;
    of.replay();
    int differ = 0;
    for (std::size_t i = 0; i < first.size(); ++i) {
      const SurfaceLight& all = of.frame.surfaces->replays()[i];
      EXPECT_NEAR(first[i].residual, all.residual, 1e-6) << name << i;
      EXPECT_NEAR(first[i].visible, all.visible, 1e-6) << name << i;
      differ += all.residual != of.frame.surfaces->light(i).residual;
    }
    EXPECT_GT(differ, kSize) << name;
  }
}

TEST(Replays, AMovingLampTouchesAllPaths) {
  EXPECT_EQ(ReplayedFrame("lamp").touched(), kSize * kSize);
}

}  // namespace
}  // namespace saccade
