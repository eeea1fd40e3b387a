// The stages against the plain path tracer: the same numbers into both, path by path. They run for every kind
// of material and light, every set of features, both widths of lanes, and one and three channels.
#include <gtest/gtest.h>

#include "base/instruction_set.h"
#include "render/bsdf_cases.h"
#include "render/one_ray_tracer.h"
#include "render/paths/trace_batch.h"
#include "render/renderer.h"
#include "render/test_scenes.h"

namespace saccade {
namespace {

constexpr int kBounces = 3;

// A box with a lamp at its ceiling, an inner block, and a sphere. `m` covers the block, the sphere and a
// wall.
Scene room(Material m) {
  Scene s;
  s.materials = {test::grey(0.6f), std::move(m)};
  s.materials[0].reflectance.color0 = {0.7f, 0.5f, 0.3f};
  s.meshes = {test::quad({-1, -1, -1}, {2, 0, 0}, {0, 2, 0}, 0),
              test::quad({-1, -1, 1}, {0, 2, 0}, {2, 0, 0}, 0),
              test::quad({-1, -1, -1}, {0, 2, 0}, {0, 0, 2}, 1),
              test::quad({1, -1, -1}, {0, 0, 2}, {0, 2, 0}, 0),
              test::quad({-1, 1, -1}, {2, 0, 0}, {0, 0, 2}, 0),
              test::quad({-1, -1, -1}, {0, 0, 2}, {2, 0, 0}, 0),
              test::quad({-0.7f, -0.2f, -0.3f}, {0.6f, 0, 0.3f}, {0, 0.4f, 0}, 1),
              test::quad({-0.3f, 0.95f, -0.3f}, {0.6f, 0, 0}, {0, 0, 0.6f}, 0, {9, 8, 7})};
  s.spheres.push_back({"ball", {0.4f, -0.6f, 0.2f}, 0.35f, 1, {}, {}});
  s.T_world_camera = {{0, 0, -0.9}, {}};
  s.fov_x_deg = 80;
  return s;
}

struct Difference {
  int paths = 0, differing = 0;  // by more than rounding may do
  double one_ray = 0, staged = 0;
};

template <Shading S, int C>
Difference compare(const Tracing& tracing, TraceBatch<C> trace) {
  const PosedScene& posed = tracing.scene;
  const RenderScene& scene = posed.still();
  constexpr int kSize = 16, kPaths = 4;
  const Camera camera(scene.description().T_world_camera,
                      pinhole(scene.description().fov_x_deg, kSize, kSize));
  const auto now = std::make_unique<LivePaths<C>>(), next = std::make_unique<LivePaths<C>>();
  const auto results = std::make_unique<PathResults<C>>();
  const auto stages = surfaceStages<S, C, false>();
  std::vector<float> expected;
  for (std::uint32_t pixel = 0; pixel < kSize * kSize; ++pixel) {
    const Vec3 direction =
        camera.direction(static_cast<float>(pixel % kSize), static_cast<float>(pixel / kSize));
    const Ray ray{camera.origin, normalize(direction), std::numeric_limits<float>::infinity()};
    const Hit hit = scene.geometry().intersect(ray);
    if (!hit.valid) continue;
    const RayCone cone{camera.pixel * hit.t, camera.pixel};
    const PathStart start{surfaceAt<S>(posed, ray, hit, cone.width), ray.direction, cone};
    for (std::uint32_t i = 0; i < kPaths && expected.size() < kBatchPaths; ++i) {
      const PathSampler sampler(7, pixel, i);
      const auto slot = static_cast<std::uint32_t>(expected.size());
      results->radiance.set(slot, Color<C>());
      stages.begin(start, sampler, slot, *now);
      expected.push_back(test::traceOneRay<S, C>(tracing, start, sampler).luminance());
    }
  }
  trace(tracing, stages, *now, *next, *results);
  Difference d;
  for (std::uint32_t slot = 0; slot < expected.size(); ++slot) {
    const float staged = results->radiance.at(slot).luminance();
    ++d.paths;
    d.differing += !(std::abs(staged - expected[slot]) <= 1e-3f * (0.05f + std::abs(expected[slot])));
    d.one_ray += expected[slot], d.staged += staged;
  }
  return d;
}

// A path that passes an edge within rounding may take another course: few do.
template <int C>
void expectSame(Scene of, bool apart, const std::string& name) {
  const PosedScene posed(std::make_shared<RenderScene>(std::move(of)));
  const Tracing tracing{posed, kBounces, {}, apart, apart};
  const RenderScene& scene = posed.still();
  const auto check = [&](TraceBatch<C> trace, const char* lanes) {
    const Difference d =
        withKernel(scene.shading(), [&]<Shading S>() { return compare<S, C>(tracing, trace); });
    EXPECT_GT(d.paths, 500) << name << lanes;
    EXPECT_LE(d.differing, d.paths / 100) << name << lanes;
    EXPECT_GT(d.one_ray, 0) << name << lanes;
    EXPECT_NEAR(d.staged, d.one_ray, 0.02 * d.one_ray) << name << lanes;
  };
  const bool mixed = scene.shading().extras || !scene.shading().diffuseOnly();
  check(batchTracerAvx2<C>(mixed, false), ", 8 lanes");
  if (instructionSet() == InstructionSet::kAvx512) check(batchTracerAvx512<C>(mixed, false), ", 16 lanes");
}
// One channel is for scenes without colours.
void makeGrey(Scene& scene) {
  for (Material& m : scene.materials)
    for (SurfaceColor* c : {&m.reflectance, &m.specular, &m.transmittance})
      c->color0 = Rgb{1, 1, 1} * luminance(c->color0);
}

// `apart`: without the light that is computed elsewhere.
void expectSame(Scene scene, const std::string& name, bool apart = false) {
  expectSame<3>(scene, apart, name + ", in colour");
  makeGrey(scene);
  expectSame<1>(std::move(scene), apart, name + ", grey");
}

Material of(const test::BsdfCase& c) {
  Material m = test::grey(0.5f);
  m.model = c.tables.model;
  m.reflectance.color0 = c.diffuse, m.specular.color0 = c.specular, m.transmittance.color0 = c.transmittance;
  return m;
}

TEST(PathStages, FindWhatOneRayFindsForEveryMaterial) {
  for (const test::BsdfCase& c : test::smoothCases()) {
    expectSame(room(of(c)), c.name);
    expectSame(room(of(c)), c.name + ", images apart", true);
  }
  for (const test::BsdfCase& c : test::roughCases({0.2f})) expectSame(room(of(c)), c.name);
}

TEST(PathStages, FindTheSameWithMasksTexturesAndBumps) {
  Material mask = test::grey(0.5f);
  mask.opacity.color0 = {0.6f, 0.6f, 0.6f};
  expectSame(room(mask), "mask");
  Scene textured = room(test::grey(0.5f));
  std::vector<Rgb> pixels;
  for (int i = 0; i < 8 * 8; ++i) pixels.push_back(Rgb{0.9f, 0.1f * static_cast<float>(i % 8), 0.2f});
  textured.textures.emplace_back(8, 8, pixels);
  SurfaceColor picture;
  picture.kind = SurfaceColor::Kind::kBitmap, picture.texture = 0;
  textured.materials[1].reflectance = picture;
  expectSame(textured, "texture");
  textured.materials[1].height = picture;
  textured.materials[1].height_scale = 0.1f;
  expectSame(textured, "bump map");
  Scene onesided = room(test::grey(0.5f, false));
  expectSame(onesided, "one-sided");
}

TEST(PathStages, FindTheSameForEveryLight) {
  Scene ball = room(test::grey(0.5f));
  ball.spheres[0].radiance = {2, 3, 4};
  expectSame(ball, "glowing sphere");
  Scene many = room(test::grey(0.5f));
  for (int i = 0; i < 20; ++i)
    many.meshes.push_back(test::quad({-0.9f + 0.08f * static_cast<float>(i), 0.9f, 0.5f}, {0.05f, 0, 0},
                                     {0, 0, 0.05f}, 0, {float(i), 5, 1}));
  expectSame(many, "many lamps");
  Scene point = room(test::grey(0.5f));
  point.point_lights.push_back({{0, 0.5f, 0}, {1, 1, 1}});
  expectSame(point, "point");
  expectSame(point, "point apart", true);
  point.meshes.back().radiance = {};
  expectSame(point, "nothing but a point, apart", true);
  Scene open = room(test::grey(0.5f));
  open.meshes.erase(open.meshes.begin() + 4);  // the ceiling
  Scene sun = open;
  sun.directional_lights.push_back({normalize(Vec3{0.3f, -1, 0.2f}), {2, 2, 2}});
  expectSame(sun, "sun");
  expectSame(sun, "sun apart", true);
  open.environment = {{1, 1, 1}, {}, {}};
  expectSame(open, "environment");
  open.directional_lights = sun.directional_lights;
  expectSame(open, "sun and environment");
  expectSame(open, "sun apart from an environment", true);
  Scene flicker = room(test::grey(0.5f));
  flicker.meshes.back().strength = Strength({{TimeNs{0}, 0.5f}});
  expectSame(flicker, "flickering lamp");
}

}  // namespace
}  // namespace saccade
