#include "render/world/render_scene.h"

#include <gtest/gtest.h>

#include "render/test_scenes.h"

namespace saccade {
namespace {

// A pane, and a wall behind it.
TEST(RenderScene, ObstaclesAreSurfacesThatLetNoLightStraightThrough) {
  Scene scene = test::floorFromAbove(0.5f);
  Material pane = test::grey(0);
  pane.model.kind = BsdfKind::kThinDielectric;
  scene.materials = {test::grey(0.5f), pane};
  scene.meshes = {test::quad({2, -1, -1}, {0, 2, 0}, {0, 0, 2}, 0),
                  test::quad({1, -1, -1}, {0, 2, 0}, {0, 0, 2}, 1)};
  const RenderScene render(scene);
  const Obstacles::Hits met = render.find({{{{0, 0, 0}, {1, 0, 0}, 3},
                                            {{0, 0, 0}, {1, 0, 0}, 1.9f},
                                            {{3, 0, 0}, {-1, 0, 0}, 3},
                                            {{0, 0, 0}, {-1, 0, 0}, 3}}});
  EXPECT_FLOAT_EQ(met[0].distance, 2);
  EXPECT_FLOAT_EQ(std::abs(met[0].normal.x), 1);
  EXPECT_TRUE(std::isinf(met[1].distance));  // out of reach
  EXPECT_FLOAT_EQ(met[2].distance, 1);
  EXPECT_TRUE(std::isinf(met[3].distance));
  EXPECT_TRUE(std::isinf(met[7].distance));  // not asked for
}

}  // namespace
}  // namespace saccade
