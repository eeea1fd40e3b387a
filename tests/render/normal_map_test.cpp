// Normal maps: the directions that their colours mean.
#include <gtest/gtest.h>

#include "render/world/bump.h"

namespace saccade {
namespace {

constexpr float kHalf = 128 / 255.f;  // of 8 bits, the nearest to no slope

// The normal that a picture of one colour gives a surface with the normal z. The axes of its texture are x
// and y.
Vec3 bentBy(Rgb colour, Vec2 uv_scale = {1, 1}, float strength = 1) {
  Scene scene;
  scene.textures.push_back(Texture(1, 1, {colour}));
  Material m;
  m.normals.kind = SurfaceColor::Kind::kBitmap;
  m.normals.texture = 0, m.normals.uv_scale = uv_scale, m.normals_scale = strength;
  EXPECT_TRUE(isBumpy(m));
  TexturePatch patch;
  patch.dp_du = {2, 0, 0.5f}, patch.dp_dv = {0, 3, 0};  // what is along the normal does not count
  return bentNormal(scene, m, {0, 0, 1}, patch, 0);
}

void expectNear(Vec3 a, Vec3 b) {
  EXPECT_NEAR(length(a - b), 0, 1e-5) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(NormalMap, OfPlainBlueIsFlat) {
  EXPECT_NEAR(bentBy({kHalf, kHalf, 1}).z, 1, 1e-4);
}

// Red leans along u, and green along v [glTF 2.0, 3.9.3].
TEST(NormalMap, LeansAlongTheAxesOfTheTexture) {
  expectNear(bentBy({0.8f, 0.5f, 0.9f}), {0.6f, 0, 0.8f});
  expectNear(bentBy({0.5f, 0.8f, 0.9f}), {0, 0.6f, 0.8f});
}

// Coordinates that grow downwards in the picture turn green round.
TEST(NormalMap, FollowsAPictureThatIsTurnedOver) {
  expectNear(bentBy({0.8f, 0.5f, 0.9f}, {-2, 1}), {-0.6f, 0, 0.8f});
  expectNear(bentBy({0.5f, 0.8f, 0.9f}, {1, -1}), {0, -0.6f, 0.8f});
}

// normalize((2 c - 1) * (scale, scale, 1)) [glTF 2.0, 5.20].
TEST(NormalMap, IsScaledBeforeItIsUnit) {
  expectNear(bentBy({0.8f, 0.5f, 0.9f}, {1, 1}, 0.5f), normalize(Vec3{0.3f, 0, 0.8f}));
}

TEST(NormalMap, StaysOnItsSideOfTheSurface) {
  EXPECT_GT(bentBy({1, 0.5f, 0}).z, 0);
}

}  // namespace
}  // namespace saccade
