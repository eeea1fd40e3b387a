// The guides of the filter in mirrors, through glass and through masks, and the light that they show.
#include <gtest/gtest.h>

#include "render/render_mean.h"
#include "render/test_scenes.h"

namespace saccade {
namespace {

constexpr int kSize = 32, kMiddle = 16;

Material clear(BsdfKind kind) {
  Material m = test::grey(0);
  m.model.kind = kind;
  return m;
}

// A camera at z = 3 over a floor of `material` at z = 0. A ceiling at z = 5 emits `radiance` and reflects
// 0.3; a lamp is between.
Scene hall(const Material& material, float radiance) {
  Scene s = test::floorFromAbove(0.3f);
  s.materials.push_back(material);
  s.meshes[0].material = 1;
  s.meshes.push_back(test::quad({-9, -9, 5}, {0, 18, 0}, {18, 0, 0}, 0, {radiance, radiance, radiance}));
  s.spheres.push_back({"lamp", {3, 0, 2}, 0.5f, 0, {5, 5, 5}});
  s.fov_x_deg = 20;
  return s;
}

Frame renderMoved(Scene scene, Vec3d by) {
  auto s = std::make_shared<RenderScene>(std::move(scene));
  TilePool pool(2);
  Frame frame(kSize, kSize);
  const Pose home = s->description().T_world_camera;
  const Camera before(home, pinhole(s->description().fov_x_deg, kSize, kSize));
  const Camera now(home * Pose{by, {}}, pinhole(s->description().fov_x_deg, kSize, kSize));
  const PosedScene posed(s);
  Renderer({2, 1}).render(PixelContext({posed, now}, {posed, before}), SeedPlan::correlated(1, 1, 2), pool,
                          frame);
  return frame;
}

TEST(Guide, OfAMirrorIsWhatItShowsWhereItSeemsToBe) {
  const Frame frame = renderMoved(hall(clear(BsdfKind::kConductor), 0), {0.01, 0, 0});
  const GBuffer& g = frame.g;
  const double pixel = 2 * std::tan(10 * std::numbers::pi / 180) / kSize;
  EXPECT_NEAR(g.z.at(kMiddle, kMiddle), 8, 1e-3);
  EXPECT_NEAR(g.motion_x.at(kMiddle, kMiddle), 0.01 / 8 / pixel, 1e-3);
  EXPECT_NEAR(g.z_in_prev.at(kMiddle, kMiddle), 8, 1e-3);
  EXPECT_NEAR(g.dz.at(kMiddle, kMiddle), 0, 1e-3);  // seen head-on
  EXPECT_NEAR(g.albedo.at(kMiddle, kMiddle), 0.3, 1e-6);
  EXPECT_EQ(g.nz.at(kMiddle, kMiddle), -1);
}

// The mirror image of a plane that leans: its slope is that of the plane seen from behind the mirror.
TEST(Guide, OfAMirrorHasTheSlopeOfTheMirrorImage) {
  Scene scene = hall(clear(BsdfKind::kConductor), 0);
  scene.meshes[1] = test::quad({-9, -9, -4}, {0, 18, 0}, {18, 0, 18}, 0);  // z = 5 + x
  Scene image = hall(test::grey(0.3f), 0);
  image.meshes[0] = test::quad({-9, -9, 4}, {18, 0, -18}, {0, 18, 0}, 0);  // z = -5 - x
  const Frame mirrored = renderMoved(std::move(scene), {}), direct = renderMoved(std::move(image), {});
  for (int x = 2; x < kSize; x += 9) {
    EXPECT_NEAR(mirrored.g.z.at(x, kMiddle), direct.g.z.at(x, kMiddle), 1e-3);
    EXPECT_NEAR(mirrored.g.dz.at(x, kMiddle), direct.g.dz.at(x, kMiddle), 1e-3);
  }
}

TEST(Guide, OfAPaneIsWhatIsBehind) {
  Scene scene = hall(test::grey(0.3f), 0);
  scene.materials.push_back(clear(BsdfKind::kThinDielectric));
  scene.meshes.push_back(test::quad({-9, -9, 1}, {18, 0, 0}, {0, 18, 0}, 2));
  const Frame frame = renderMoved(std::move(scene), {0.01, 0, 0});
  const double reflected = 2 * 0.04 / 1.04;
  EXPECT_NEAR(frame.g.z.at(kMiddle, kMiddle), 3, 1e-3);
  EXPECT_NEAR(frame.g.albedo.at(kMiddle, kMiddle), reflected + (1 - reflected) * 0.3, 1e-3);
}

// Emission along the view is known exactly: were it sampled too, it would count twice.
TEST(Guide, EmissionInAMirrorAndThroughAPaneIsFreeOfNoise) {
  for (const BsdfKind kind : {BsdfKind::kConductor, BsdfKind::kThinDielectric}) {
    Scene scene = hall(clear(kind), 2);
    scene.spheres.clear();
    scene.materials[0] = test::grey(0);  // reflects nothing
    if (kind == BsdfKind::kThinDielectric)
      scene.meshes.push_back(test::quad({-9, -9, -1}, {18, 0, 0}, {0, 18, 0}, 0, {2, 2, 2}));
    const Frame frame = test::renderFrame(std::move(scene), 2, 4096, 4);
    const double seen = kind == BsdfKind::kConductor ? 1 : 1 - 0.08 / 1.04;
    EXPECT_NEAR(frame.g.emission.at(2, 2), 2 * seen, 1e-3);
    EXPECT_NEAR(test::meanOf(frame.samples.I2).mean, 2, 0.02);  // with what the pane reflects
  }
}

TEST(Guide, OfAThinMaskIsWhatIsBehind) {
  Scene scene = hall(test::grey(0.3f), 0);
  Material mask = test::grey(0.9f);
  mask.opacity.color0 = {0.25f, 0.25f, 0.25f};
  scene.materials.push_back(mask);
  scene.meshes.push_back(test::quad({-9, -9, 1}, {18, 0, 0}, {0, 18, 0}, 2));
  EXPECT_NEAR(renderMoved(scene, {}).g.z.at(kMiddle, kMiddle), 3, 1e-3);
  scene.materials.back().opacity.color0 = {0.75f, 0.75f, 0.75f};
  EXPECT_NEAR(renderMoved(scene, {}).g.z.at(kMiddle, kMiddle), 2, 1e-3);
}

TEST(Guide, EndsWhereTheViewLeavesTheScene) {
  Scene scene = hall(clear(BsdfKind::kConductor), 0);
  scene.meshes.pop_back();
  scene.spheres.clear();
  scene.environment = {{2, 2, 2}, {}, {}};
  const Frame frame = renderMoved(std::move(scene), {0.01, 0, 0});
  EXPECT_EQ(frame.g.z.at(kMiddle, kMiddle), kMissDepth);
  EXPECT_NEAR(frame.g.motion_x.at(kMiddle, kMiddle), 0, 1e-4);
  EXPECT_NEAR(frame.samples.I2.at(kMiddle, kMiddle), 2, 1e-5);
}

}  // namespace
}  // namespace saccade
