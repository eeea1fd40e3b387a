// Colours of vertices, against equal colours of the material.
#include <gtest/gtest.h>

#include "render/renderer.h"
#include "render/test_scenes.h"

namespace saccade {
namespace {

constexpr int kSize = 16;

// A wall of metallic-roughness under an even sky.
Scene wall(Rgb base) {
  Scene s;
  Material m = test::grey(0);
  m.model.kind = BsdfKind::kMetallicRoughness;
  m.reflectance = constantColor(base);
  s.materials = {m};
  s.meshes = {test::quad({-2, -2, 2}, {0, 4, 0}, {4, 0, 0}, 0)};
  s.environment = Environment{{1, 1, 1}, {}, {}};
  return s;
}

Frame render(Scene scene) {
  TilePool pool(1);
  Frame frame(kSize, kSize);
  const PosedScene posed(std::make_shared<RenderScene>(std::move(scene)));
  const Camera camera(Pose{}, pinhole(60, kSize, kSize));
  const PosedView view{posed, camera};
  Renderer renderer({1, 3});
  renderer.render(PixelContext(view, view), SeedPlan::correlated(1, 1, 16), pool, frame);
  return frame;
}

TEST(VertexColors, AreFactorsOfTheBaseColour) {
  Scene colored = wall({0.8f, 0.8f, 0.8f});
  colored.meshes[0].colors.assign(4, {0.5f, 0.25f, 1});
  EXPECT_EQ(colorChannels(colored), 3);
  const Frame a = render(std::move(colored)), b = render(wall({0.4f, 0.2f, 0.8f}));
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      EXPECT_FLOAT_EQ(a.g.albedo.at(x, y), b.g.albedo.at(x, y));
      EXPECT_FLOAT_EQ(a.samples.I2.at(x, y), b.samples.I2.at(x, y));
    }
}

// From black on the left to white on the right: the albedo of the base grows as x does.
TEST(VertexColors, AreLinearBetweenVertices) {
  Scene ramp = wall({1, 1, 1});
  for (std::size_t i = 0; i < 4; ++i) {
    const float share = (ramp.meshes[0].positions[i].x + 2) / 4;
    ramp.meshes[0].colors.push_back({share, share, share});
  }
  Scene black = wall({0, 0, 0}), white = wall({1, 1, 1});
  const Frame a = render(std::move(ramp)), low = render(std::move(black)), high = render(std::move(white));
  const Camera camera(Pose{}, pinhole(60, kSize, kSize));
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const Vec3 d = camera.direction(static_cast<float>(x), static_cast<float>(y));
      const float share = (2 * d.x + 2) / 4;
      const float l = low.g.albedo.at(x, y), h = high.g.albedo.at(x, y);
      EXPECT_NEAR(a.g.albedo.at(x, y), l + (h - l) * share, 1e-5f);
    }
}

}  // namespace
}  // namespace saccade
