#include "scene/scene_hash.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>

namespace saccade {
namespace {

Scene shinyScene() {
  Scene scene;
  scene.materials.resize(1);
  scene.materials[0].model.kind = BsdfKind::kRoughPlastic;
  scene.environment = Environment{{1, 1, 1}, {1, 1, {{2, 2, 2}}}, {}};
  scene.point_lights = {{{0, 0, 0}, {1, 1, 1}}};
  scene.spot_lights = {{{0, 0, 0}, {0, 0, 1}, {1, 1, 1}, 0.1f, 0.2f}};
  scene.directional_lights = {{{0, 0, 1}, {1, 1, 1}}};
  return scene;
}

TEST(SceneHash, TellsApartWhatDiffersInOneThing) {
  const std::vector<std::function<void(Scene&)>> changes = {
      [](Scene&) {},
      [](Scene& s) { s.materials[0].reflectance.color0.x = 0.5f; },
      [](Scene& s) { s.materials[0].specular.color0.x = 0.5f; },
      [](Scene& s) { s.materials[0].transmittance.color0.x = 0.5f; },
      [](Scene& s) { s.materials[0].opacity.color0.x = 0.5f; },
      [](Scene& s) { s.materials[0].height.kind = SurfaceColor::Kind::kCheckerboard; },
      [](Scene& s) { s.materials[0].height_scale = 2; },
      [](Scene& s) { s.materials[0].normals.kind = SurfaceColor::Kind::kCheckerboard; },
      [](Scene& s) { s.materials[0].model.kind = BsdfKind::kMetallicRoughness; },
      [](Scene& s) {
        s.materials[0].model.kind = BsdfKind::kMetallicRoughness;
        s.materials[0].metallic_roughness.color0.y = 0.5f;
      },
      [](Scene& s) { s.materials[0].twosided = true; },
      [](Scene& s) { s.materials[0].model.kind = BsdfKind::kPlastic; },
      [](Scene& s) { s.materials[0].model.microfacets = MicrofacetKind::kGgx; },
      [](Scene& s) { s.materials[0].model.alpha = 0.2f; },
      [](Scene& s) { s.materials[0].model.ior = 1.4f; },
      [](Scene& s) { s.materials[0].model.eta.x = 2; },
      [](Scene& s) { s.materials[0].model.k.x = 2; },
      [](Scene& s) { s.materials[0].model.nonlinear = true; },
      [](Scene& s) { s.materials[0].model.scatters_once = true; },
      [](Scene& s) { s.materials[0].model.coat_ior = 1.5f; },
      [](Scene& s) { s.materials[0].model.coat_alpha = 0.2f; },
      [](Scene& s) { s.materials[0].emission.kind = SurfaceColor::Kind::kCheckerboard; },
      [](Scene& s) { s.materials[0].specular.second_uvs = true; },
      [](Scene& s) { s.environment->radiance.x = 2; },
      [](Scene& s) { s.environment->picture.pixels[0].x = 3; },
      [](Scene& s) {
        s.environment->to_world.x = {-1, 0, 0};
      },
      [](Scene& s) { s.environment.reset(); },
      [](Scene& s) { s.point_lights[0].position.x = 1; },
      [](Scene& s) { s.point_lights[0].intensity.x = 2; },
      [](Scene& s) {
        s.spot_lights[0].axis = {0, 1, 0};
      },
      [](Scene& s) { s.spot_lights[0].intensity.x = 2; },
      [](Scene& s) { s.spot_lights[0].cutoff = 0.3f; },
      [](Scene& s) {
        s.directional_lights[0].direction = {1, 0, 0};
      },
      [](Scene& s) { s.directional_lights[0].irradiance.x = 2; },
      [](Scene& s) { s.bodies.resize(1); },
      [](Scene& s) { s.bodies.resize(1), s.point_lights[0].body = 0; },
      [](Scene& s) { s.bodies.resize(1), s.spot_lights[0].body = 0; },
      [](Scene& s) { s.bodies.resize(1), s.directional_lights[0].body = 0; },
  };
  std::set<std::uint64_t> hashes;
  for (const auto& change : changes) {
    Scene scene = shinyScene();
    change(scene);
    hashes.insert(hashScene(scene));
  }
  EXPECT_EQ(hashes.size(), changes.size());
}

TEST(SceneHash, OfADiffuseMaterialOnlyItsReflectanceCounts) {
  Scene a, b;
  a.materials.resize(1), b.materials.resize(1);
  b.materials[0].model.alpha = 0.5f;
  EXPECT_EQ(hashScene(a), hashScene(b));
}

TEST(SceneHash, TellsATextureFromItselfWithoutMips) {
  Scene scene = shinyScene();
  scene.textures = {Texture(2, 1, {{0, 0, 0}, {1, 1, 1}})};
  const std::uint64_t filtered = hashScene(scene);
  scene.textures[0].dropMips();
  EXPECT_NE(hashScene(scene), filtered);
}

}  // namespace
}  // namespace saccade
