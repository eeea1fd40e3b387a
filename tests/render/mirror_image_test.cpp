// The images of lamps in coats and glass: against Fresnel's formula, and against the light of paths.
#include <gtest/gtest.h>

#include "render/primary/sub_pixel.h"
#include "render/render_mean.h"
#include "render/test_scenes.h"

namespace saccade {
namespace {

constexpr int kSize = 24;
constexpr float kEye = 3, kLamp = 4, kRadiance = 5, kIor = 1.49f;  // heights; of the lamp

Material smooth(BsdfKind kind, float albedo) {
  Material m = test::grey(albedo);
  m.model.kind = kind, m.model.ior = m.model.coat_ior = kIor;
  return m;
}

// A floor of `material` seen from above, and a lamp behind the camera that spans x from 1 to 3.
Scene floorUnderALamp(const Material& material) {
  Scene s = test::floorFromAbove(0);
  s.materials.push_back(material);
  s.meshes[0].material = 1;
  s.meshes.push_back(test::quad({1, -9, kLamp}, {0, 18, 0}, {2, 0, 0}, 0, {kRadiance, kRadiance, kRadiance}));
  s.fov_x_deg = 60;
  return s;
}

Frame renderSurfaces(const Scene& scene, int spp, int points = 1) {
  const PosedScene posed(std::make_shared<RenderScene>(scene));
  TilePool pool(2);
  Frame frame(kSize, kSize, points);
  const Camera camera(scene.T_world_camera, pinhole(scene.fov_x_deg, kSize, kSize));
  const PixelContext view({posed, camera});
  Renderer renderer({2, 1, points > 1});
  const SurfaceFrame next = renderer.renderSurfaces(view, pool, frame);
  for (int y = 0; y < kSize; ++y)
    for (SurfacePoint& p : frame.surfaces->row(y)) p.paths = static_cast<std::uint32_t>(spp);
  renderer.renderPaths(view.now, SeedPlan::independent(1, 0, spp), next, nullptr, pool);
  return frame;
}

// A pixel's place on the floor.
double floorAt(int pixel) {
  return (pixel + 0.5 - kSize / 2.) * 2 * kEye * std::tan(std::numbers::pi / 6) / kSize;
}

// The share of unpolarised light that a dielectric reflects [Born and Wolf, 1.5.2].
double fresnel(double cos_i) {
  const double cos_t = std::sqrt(1 - (1 - cos_i * cos_i) / (kIor * kIor));
  const double s = (cos_i - kIor * cos_t) / (cos_i + kIor * cos_t);
  const double p = (kIor * cos_i - cos_t) / (kIor * cos_i + cos_t);
  return (s * s + p * p) / 2;
}
double reflectance(BsdfKind kind, double cos_i) {
  const double f = fresnel(cos_i);
  return kind == BsdfKind::kThinDielectric ? 2 * f / (1 + f) : f;
}

TEST(MirrorImage, IsFresnelTimesEmissionAtTheMirroredPlace) {
  for (const BsdfKind kind :
       {BsdfKind::kPlastic, BsdfKind::kDielectric, BsdfKind::kThinDielectric, BsdfKind::kCoatedConductor}) {
    const Frame frame = renderSurfaces(floorUnderALamp(smooth(kind, 0.2f)), 1);
    int lit = 0, dark = 0;
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) {
        const double at = floorAt(x), mirrored = at * (kEye + kLamp) / kEye;
        const bool shows = mirrored > 1 && mirrored < 3;
        const double cosine = kEye / std::hypot(at, floorAt(y), kEye);
        EXPECT_NEAR(frame.g.emission.at(x, y), shows ? kRadiance * reflectance(kind, cosine) : 0, 1e-5);
        ++(shows ? lit : dark);
      }
    EXPECT_GT(lit, kSize);
    EXPECT_GT(dark, kSize);
  }
}

TEST(MirrorImage, ShowsTheSky) {
  Scene scene = floorUnderALamp(smooth(BsdfKind::kPlastic, 0.2f));
  scene.meshes.pop_back();
  scene.environment = {{2, 2, 2}, {}, {}};
  const Frame frame = renderSurfaces(scene, 1);
  EXPECT_NEAR(frame.g.emission.at(kSize / 2, kSize / 2), 2 * fresnel(1), 1e-3);
}

// Other methods and references let their paths find the image.
TEST(MirrorImage, IsNoEmissionOfPlainFrames) {
  const Frame frame = test::renderFrame(floorUnderALamp(smooth(BsdfKind::kPlastic, 0.2f)), 2, 1, kSize);
  EXPECT_EQ(test::meanOf(frame.g.emission).mean, 0);
}

// Paths do not find the image again, nor do they miss other light that the coat mirrors.
TEST(MirrorImage, CountsOnceBesidePaths) {
  for (const BsdfKind kind : {BsdfKind::kPlastic, BsdfKind::kDielectric, BsdfKind::kThinDielectric}) {
    Scene scene = floorUnderALamp(smooth(kind, 0.2f));
    scene.materials[0] = test::grey(0.7f);
    scene.meshes.push_back(
        test::quad({-3, -9, 2}, {0, 18, 0}, {2, 0, 0}, 0));  // lit by what the floor reflects
    scene.meshes.push_back(test::quad({-9, -9, -2}, {18, 0, 0}, {0, 18, 0}, 0));  // below glass
    const double all = test::meanOf(test::renderFrame(scene, 2, 1024, kSize).samples.I2).mean;
    EXPECT_NEAR(test::meanOf(renderSurfaces(scene, 512).samples.I2).mean, all, 0.01 * all);
    EXPECT_NEAR(test::meanOf(renderSurfaces(scene, 128, kSubPixels).samples.I2).mean, all, 0.02 * all);
  }
}

// A mask over a coat thins its image.
TEST(MirrorImage, IsThinnedByAMask) {
  Material mask = smooth(BsdfKind::kPlastic, 0.2f);
  mask.opacity.color0 = {0.5f, 0.5f, 0.5f};
  const Scene half = floorUnderALamp(mask), whole = floorUnderALamp(smooth(BsdfKind::kPlastic, 0.2f));
  for (const int points : {1, static_cast<int>(kSubPixels)}) {
    const double all = test::meanOf(renderSurfaces(whole, 1, points).g.emission).mean;
    EXPECT_NEAR(test::meanOf(renderSurfaces(half, 1, points).g.emission).mean, all / 2, 0.01 * all);
  }
}

}  // namespace
}  // namespace saccade
