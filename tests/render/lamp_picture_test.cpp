// Lamps whose light varies over their surface, against equal lamps in parts.
#include <gtest/gtest.h>

#include "render/render_mean.h"
#include "render/test_scenes.h"
#include "render/world/posed_lamps.h"
#include "render/world/surface_at.h"

namespace saccade {
namespace {

using test::Mean;
using test::renderMean;

constexpr float kFiltered = 0.02f;  // how exactly a checkerboard is filtered over a point

// Of a lamp's unit square in texture space, the part with u below a half gives twice the mean, the rest none.
SurfaceColor halves() {
  SurfaceColor c;
  c.kind = SurfaceColor::Kind::kCheckerboard;
  c.color0 = {2, 2, 2}, c.color1 = {0, 0, 0};
  c.uv_scale = {1, 0}, c.uv_offset = {0, 0.25f};
  return c;
}

// A floor that the camera sees from below a lamp, which lies to its right and faces it. Its bright half is
// the nearer one. `others`: more lamps, far away, so that a tree chooses.
Scene floorWith(Mesh lamp, bool others = false) {
  Scene s = test::floorFromAbove(0.6f);
  s.T_world_camera.position.z = 0.8;
  Material glow = test::grey(0);
  glow.emission = halves();
  s.materials.push_back(glow);
  s.meshes.push_back(std::move(lamp));
  if (others) s.meshes.push_back(test::quad({9, 9, 9}, {0, 0.1f, 0}, {0.1f, 0, 0}, 0, {1, 1, 1}));
  return s;
}
Mesh pictured() {
  return test::quad({0.2f, -0.7f, 1}, {0, 1.4f, 0}, {1.6f, 0, 0}, 1, {3, 3, 3});
}
// The bright half alone: u grows along the first edge.
Mesh brightHalf() {
  return test::quad({0.2f, -0.7f, 1}, {0, 0.7f, 0}, {1.6f, 0, 0}, 0, {6, 6, 6});
}

TEST(LampPicture, LightsAFloorAsItsBrightPartDoes) {
  for (const bool others : {false, true}) {
    const Mean part = renderMean(floorWith(brightHalf(), others), 0, 256),
               whole = renderMean(floorWith(pictured(), others), 0, 256);
    EXPECT_NEAR(whole.mean, part.mean, 5 * std::hypot(whole.error, part.error)) << others;
    EXPECT_LT(part.error / part.mean, 0.02);
  }
}

TEST(LampPicture, IsSeenAsItIs) {
  Scene scene = floorWith(pictured());
  scene.T_world_camera = {};  // at the floor, looking along z
  const PosedScene posed(std::make_shared<RenderScene>(std::move(scene)));
  const auto radianceAt = [&](float y) {
    const Ray ray{{1, y, 0.5f}, {0, 0, 1}, 9};
    return surfaceAt<kEverything>(posed, ray, posed.still().geometry().intersect(ray), 1e-4f).radiance.x;
  };
  EXPECT_NEAR(radianceAt(-0.3f), 6, kFiltered);
  EXPECT_NEAR(radianceAt(0.3f), 0, kFiltered);
}

// In these u grows along the second edge, with x.
TEST(LampPicture, MayHaveTheSecondCoordinates) {
  Mesh lamp = pictured();
  lamp.second_uvs = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};
  Scene scene = floorWith(lamp);
  scene.materials.back().emission.second_uvs = true;
  const Lamps lamps(scene);
  for (int i = 0; i < 16; ++i) {
    const IncidentLight light =
        lamps.sample({static_cast<std::uint32_t>(i % 2), 1}, {}, (static_cast<float>(i) + 0.5f) / 16, 0.3f);
    EXPECT_NEAR(light.radiance.x, light.segment.x < 1 ? 6 : 0, kFiltered) << light.segment.x;
  }
  const PosedScene posed(std::make_shared<RenderScene>(std::move(scene)));
  for (const float x : {0.5f, 1.5f}) {
    const Ray ray{{x, 0, 0.5f}, {0, 0, 1}, 9};
    const Hit hit = posed.still().geometry().intersect(ray);
    EXPECT_NEAR(surfaceAt<kEverything>(posed, ray, hit, 1e-4f).radiance.x, x < 1 ? 6 : 0, kFiltered);
  }
}

TEST(LampPicture, HasNoClosedForm) {
  const RenderScene scene(floorWith(pictured()));
  EXPECT_FALSE(scene.analyticLight().holds(1));
  EXPECT_TRUE(RenderScene(floorWith(brightHalf())).analyticLight().holds(1));
}

// The triangles of a quad are one lamp of the mean light; a sample has the light of its place.
TEST(LampPicture, IsSampledByItsPlaces) {
  const Scene scene = floorWith(pictured());
  const Lamps lamps(scene);
  ASSERT_EQ(lamps.areaLamps().size(), 2u);
  EXPECT_NEAR(lamps.areaLamps()[0].radiance.x, 3, 0.2);
  EXPECT_EQ(lamps.areaLamps()[0].radiance, lamps.areaLamps()[1].radiance);
  for (int i = 0; i < 16; ++i) {
    const IncidentLight light =
        lamps.sample({static_cast<std::uint32_t>(i % 2), 1}, {}, (static_cast<float>(i) + 0.5f) / 16, 0.3f);
    EXPECT_NEAR(light.radiance.x, light.segment.y < 0 ? 6 : 0, kFiltered) << light.segment.y;
  }
}

TEST(LampPicture, MovesWithItsLamp) {
  Scene scene = floorWith(pictured());
  scene.meshes.back().body = 0;
  scene.bodies.resize(1);
  Texture picture(2, 1, {{2, 2, 2}, {0, 0, 0}});
  picture.setWrap(Texture::Wrap::kClamp, Texture::Wrap::kClamp);
  scene.textures.push_back(std::move(picture));
  SurfaceColor& emission = scene.materials.back().emission;
  emission = {};
  emission.kind = SurfaceColor::Kind::kBitmap, emission.texture = 0;
  PosedLamps posed(scene, Lights(scene));
  const RigidMotion up{.translation = {0, 0, 5}};
  posed.place(scene, {&up, 1});
  const IncidentLight light = posed.lights.lamps().sample({0, 1}, {}, 0.96f, 0.2f);  // at u = 0.22
  EXPECT_NEAR(light.segment.z, 6, 1e-5);
  EXPECT_FLOAT_EQ(light.radiance.x, 6);
}

}  // namespace
}  // namespace saccade
