#include "scene/scene_stats.h"

#include <gtest/gtest.h>

#include "scene/mesh/mesh.h"

namespace saccade {
namespace {

// A cube (24 corners with uv and normals, 12 triangles), a rectangle that shines, a sphere that does.
Scene scene() {
  Scene s;
  s.materials.resize(3);
  for (Material& m : s.materials) m.reflectance = constantColor({0.5f, 0.5f, 0.5f});
  s.materials[1].model.kind = BsdfKind::kRoughPlastic;
  s.meshes = {makeCube(), makeRectangle()};
  for (Mesh& mesh : s.meshes) placeMesh(mesh, {}, false);
  s.meshes[1].radiance = {1, 1, 1};
  s.spheres.resize(1);
  s.spheres[0].radiance = {2, 2, 2};
  return s;
}

TEST(SceneStats, CountWhatIsThere) {
  const SceneStats stats = statsOf(scene());
  EXPECT_EQ(stats.triangles, 14u);
  EXPECT_EQ(stats.meshes, 2u);
  EXPECT_EQ(stats.spheres, 1u);
  EXPECT_EQ(stats.materials,
            (std::map<BsdfKind, int>{{BsdfKind::kDiffuse, 2}, {BsdfKind::kRoughPlastic, 1}}));
  EXPECT_EQ(stats.area_lights, 2);
  EXPECT_EQ(stats.environments + stats.point_lights + stats.directional_lights, 0);
  EXPECT_EQ(stats.masks + stats.bump_maps, 0);
  EXPECT_EQ(stats.textures, 0u);
  EXPECT_EQ(stats.texture_bytes, 0u);
  EXPECT_EQ(stats.channels, 1);
}

TEST(SceneStats, CountMasksBumpMapsAndOtherLights) {
  Scene s = scene();
  s.materials[0].opacity = constantColor({0.5f, 0.5f, 0.5f});
  s.materials[1].height.kind = SurfaceColor::Kind::kCheckerboard;
  s.materials[2].height.kind = SurfaceColor::Kind::kCheckerboard;
  s.environment = Environment{{1, 1, 1}, {}, {}};
  s.point_lights.resize(2);
  s.directional_lights.resize(3);
  const SceneStats stats = statsOf(s);
  EXPECT_EQ(stats.masks, 1);
  EXPECT_EQ(stats.bump_maps, 2);
  EXPECT_EQ(stats.environments, 1);
  EXPECT_EQ(stats.point_lights, 2);
  EXPECT_EQ(stats.directional_lights, 3);
}

// Position, normal and uv of a corner take 12 + 12 + 8 bytes, a triangle 12; a position more for Embree.
TEST(SceneStats, BytesOfGeometryAreThoseOfItsArrays) {
  Scene s = scene();
  s.spheres.clear();
  const std::size_t corners = 24 + 4, triangles = 12 + 2;
  const SceneStats stats = statsOf(s);
  EXPECT_EQ(stats.geometry_bytes, corners * 32 + 2 * 12 + triangles * 12);
  EXPECT_DOUBLE_EQ(stats.bytesPerTriangle(), static_cast<double>(stats.geometry_bytes) / 14);
  EXPECT_EQ(SceneStats().bytesPerTriangle(), 0);
}

// 4 x 2 has levels of 2 x 1 and 1 x 1.
TEST(SceneStats, BytesOfTexturesAreThoseOfTheirMips) {
  Scene s = scene();
  s.textures.assign(2, Texture(4, 2, std::vector<Rgb>(8)));
  EXPECT_EQ(statsOf(s).textures, 2u);
  EXPECT_EQ(statsOf(s).texture_bytes, 2 * (8 + 2 + 1) * 12u);
  s.textures[0].dropMips();
  EXPECT_EQ(statsOf(s).texture_bytes, (8 + 8 + 2 + 1) * 12u);
  s.environment = Environment{{1, 1, 1}, {5, 1, std::vector<Rgb>(5)}, {}};
  EXPECT_EQ(statsOf(s).texture_bytes, (8 + 8 + 2 + 1 + 5) * 12u);
}

TEST(SceneStats, SayInOneLineWhatIsThereAndNothingElse) {
  Scene s = scene();
  s.spheres.clear();
  s.materials[0].reflectance.color0.x = 0.9f;
  EXPECT_EQ(
      statsOf(s).text(),
      "14 triangles, 2 meshes, 2 diffuse, 1 roughplastic, 1 area light, 3 channels; geometry 0.0 MiB (78 "
      "bytes per triangle), textures 0.0 MiB");
}

}  // namespace
}  // namespace saccade
