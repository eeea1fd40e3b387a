#include "eval/reference.h"

#include <filesystem>

#include "render/test_scenes.h"
#include "scene/scratch.h"

namespace saccade {
namespace {

using namespace std::chrono_literals;

constexpr int kW = 8, kH = 6;

struct Fixture : ::testing::Test {
  Scratch files;
  TilePool pool{2};
  Progress progress{"reference", 1};

  // A floor under a ball that shines with this strength.
  std::shared_ptr<const RenderScene> scene(Strength strength) const {
    Scene s = test::floorFromAbove(0.6f);
    s.spheres.push_back({"ball", {0, 0, 0.8f}, 0.4f, 0, {5, 5, 5}, std::move(strength)});
    return std::make_shared<RenderScene>(std::move(s));
  }
  ReferenceRenderer renderer(std::shared_ptr<const RenderScene> scene) {
    std::filesystem::create_directories(files.path("cache"));
    return {scene, 1, kW, kH, 60, files.path("cache"), pool};
  }
  long kept() const { return std::distance(std::filesystem::directory_iterator(files.path("cache")), {}); }
};

TEST_F(Fixture, ShowsAndKeepsAFrameForEveryStrengthOfItsLamp) {
  const auto switched = scene(Strength({{0ms, 1}, {50ms, 1}, {50ms, 0.25f}}));
  const Pose pose = switched->description().T_world_camera;
  ReferenceRenderer reference = renderer(switched);
  const ReferenceFrame on = reference.frame(pose, 0ms, 64, progress);
  const ReferenceFrame off = reference.frame(pose, 50ms, 64, progress);
  EXPECT_EQ(kept(), 2);
  const ReferenceFrame still_on = reference.frame(pose, 20ms, 64, progress);
  EXPECT_EQ(kept(), 2);
  EXPECT_GT(on.a.at(0, 0), 0);
  for (int y = 0; y < kH; ++y) {
    for (int x = 0; x < kW; ++x) {
      ASSERT_EQ(off.a.at(x, y), 0.25f * on.a.at(x, y));
      ASSERT_EQ(off.b.at(x, y), 0.25f * on.b.at(x, y));
      ASSERT_EQ(still_on.a.at(x, y), on.a.at(x, y));
    }
  }
}

TEST_F(Fixture, TimeIsNothingToASceneThatStaysAsItIs) {
  const auto steady = scene({});
  const Pose pose = steady->description().T_world_camera;
  ReferenceRenderer reference = renderer(steady);
  reference.frame(pose, 0ms, 64, progress);
  reference.frame(pose, 50ms, 64, progress);
  EXPECT_EQ(kept(), 1);
}

}  // namespace
}  // namespace saccade
