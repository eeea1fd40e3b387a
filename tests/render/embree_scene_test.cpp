#include "render/world/embree_scene.h"

#include <gtest/gtest.h>

#include "render/test_scenes.h"

namespace saccade {
namespace {

TEST(EmbreeScene, HitsTrianglesAndSpheresFromBothSides) {
  Scene s;
  s.materials = {test::grey(0.5f)};
  s.meshes = {test::quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, 0)};
  s.spheres = {{"ball", {0, 0, 5}, 1, 0, {}}};
  const EmbreeScene e(s);

  const Hit wall = e.intersect({{0.2f, 0.3f, -2}, {0, 0, 2}, 100});
  ASSERT_TRUE(wall.valid);
  EXPECT_FLOAT_EQ(wall.t, 1);  // in units of the direction's length
  EXPECT_EQ(wall.geometry, 0u);
  EXPECT_GT(wall.normal.z, 0);  // as wound

  const Hit outside = e.intersect({{0, 0, 8}, {0, 0, -1}, 100});
  ASSERT_TRUE(outside.valid);
  EXPECT_NEAR(outside.t, 2, 1e-5);
  EXPECT_EQ(outside.geometry, 1u);
  const Hit inside = e.intersect({{0, 0, 5}, {0, 0, 1}, 100});
  ASSERT_TRUE(inside.valid);
  EXPECT_NEAR(inside.t, 1, 1e-5);
  EXPECT_GT(inside.normal.z, 0);  // outwards

  EXPECT_TRUE(e.occluded({{0, 0, -2}, {0, 0, 1}, 3}));
  EXPECT_FALSE(e.occluded({{0, 0, -2}, {0, 0, 1}, 1.9f}));
  EXPECT_FALSE(e.intersect({{0, 0, -2}, {0, 0, -1}, 100}).valid);
}

TEST(EmbreeScene, OfEmittersHasNothingElse) {
  Scene s;
  s.materials = {test::grey(0.5f)};
  s.meshes = {test::quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, 0),
              test::quad({-1, -1, 1}, {2, 0, 0}, {0, 2, 0}, 0)};
  s.meshes[1].radiance = {1, 1, 1};
  s.spheres = {{"ball", {5, 0, 5}, 1, 0, {}}, {"lamp", {0, 0, 9}, 1, 0, {1, 1, 1}}};
  const EmbreeScene e(s, EmbreeScene::Shapes::kEmitters);
  const Ray along{{0, 0, -2}, {0, 0, 1}, 100}, back{{0, 0, 20}, {0, 0, -1}, 100};
  EXPECT_EQ(e.intersect(along).geometry, 1u);
  EXPECT_EQ(e.intersect(back).geometry, 3u);
  EXPECT_FALSE(e.occluded({{0, 0, -2}, {0, 0, 1}, 2.5f}));
  EXPECT_FALSE(e.occluded({{5, 0, -2}, {0, 0, 1}, 100}));
}

}  // namespace
}  // namespace saccade
