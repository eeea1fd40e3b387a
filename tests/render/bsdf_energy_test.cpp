// White furnaces: what a surface reflects and lets through, in all directions together.
#include <gtest/gtest.h>

#include "render/bsdf_cases.h"

namespace saccade {
namespace {

constexpr float kCosines[] = {0.05f, 0.2f, 0.6f, 1.f};

// Power towards wo from everywhere, from samples; for glass without the change of radiance.
Vec3d sampledAlbedo(const test::BsdfCase& c, Vec3 wo, int count) {
  Vec3d sum;
  const float ior2 = c.tables.model.ior * c.tables.model.ior;
  const bool refracts = c.tables.model.kind == BsdfKind::kDielectric;
  for (int i = 0; i < count; ++i) {
    const auto at = static_cast<std::uint64_t>(i);
    const float u_lobe = (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
    const BsdfSample s = sampleBsdf(c.bsdf(), wo, u_lobe, test::uniformAt(1, at), test::uniformAt(2, at));
    const float change = !refracts || !s.transmitted ? 1 : wo.z > 0 ? ior2 : 1 / ior2;
    sum = sum + toDouble(s.weight) * static_cast<double>(change);
  }
  return sum / static_cast<double>(count);
}

// The same from values, by midpoints in azimuth and polar angle; delta lobes are not in it.
Vec3d integratedAlbedo(const test::BsdfCase& c, Vec3 wo, int steps = 160) {
  Vec3d sum;
  for (int i = 0; i < steps; ++i) {
    const double theta = (i + 0.5) / steps * std::numbers::pi / 2;
    for (int j = 0; j < steps; ++j) {
      const Vec3 wi = test::directionAt(std::cos(theta), (j + 0.5) / steps * std::numbers::pi);
      sum = sum + toDouble(evaluateBsdf(c.bsdf(), wo, wi).value) * std::sin(theta);
    }
  }
  return sum * (std::numbers::pi * std::numbers::pi / steps / steps);  // twice the half with y > 0
}

void expectNear(Rgb albedo, Vec3d expected, double relative, const std::string& what) {
  EXPECT_NEAR(albedo.x, expected.x, relative * expected.x) << what;
  EXPECT_NEAR(albedo.y, expected.y, relative * expected.y) << what;
  EXPECT_NEAR(albedo.z, expected.z, relative * expected.z) << what;
}

TEST(Albedo, IsTheIntegralOfTheValue) {
  std::vector<test::BsdfCase> cases = test::roughCases({0.2f, 0.6f, 1.f});
  cases.push_back(test::smoothCases()[0]);
  for (test::BsdfCase& c : test::metallicRoughnessCases({0.45f, 0.8f, 1.f})) cases.push_back(std::move(c));
  for (test::BsdfCase& c : test::glossCases({0.2f, 0.6f, 1.f})) cases.push_back(std::move(c));
  for (test::BsdfCase& c : test::coatedCases({0.2f, 0.6f, 1.f}))
    if (c.tables.model.coat_alpha > 0) cases.push_back(std::move(c));
  for (const test::BsdfCase& c : cases) {
    for (const float cos_o : kCosines)
      expectNear(bsdfAlbedo(c.bsdf(), cos_o), integratedAlbedo(c, test::directionAt(cos_o)), 0.01,
                 c.name + " from " + std::to_string(cos_o));
  }
}

TEST(Albedo, IsTheMeanWeightOfSamples) {
  std::vector<test::BsdfCase> cases = test::smoothCases();
  for (test::BsdfCase& c : test::roughCases({0.02f, 0.1f, 0.5f})) cases.push_back(std::move(c));
  for (test::BsdfCase& c : test::metallicRoughnessCases({0.15f, 0.3f, 0.7f})) cases.push_back(std::move(c));
  for (test::BsdfCase& c : test::glossCases({0.02f, 0.1f, 0.5f})) cases.push_back(std::move(c));
  for (test::BsdfCase& c : test::coatedCases({0.02f, 0.1f, 0.5f})) cases.push_back(std::move(c));
  for (const test::BsdfCase& c : cases) {
    for (const float cos_o : {0.05f, 0.2f, 0.6f, 1.f, -0.9f}) {
      if (cos_o < 0 && c.name != "dielectric" && c.name != "pane") continue;
      expectNear(bsdfAlbedo(c.bsdf(), cos_o), sampledAlbedo(c, test::directionAt(cos_o), 20000), 0.015,
                 c.name + " from " + std::to_string(cos_o));
    }
  }
}

TEST(Furnace, NothingReflectsMoreThanItGets) {
  std::vector<test::BsdfCase> cases = test::smoothCases();
  for (test::BsdfCase& c : test::roughCases({0.f, 0.02f, 0.1f, 0.3f, 1.f})) cases.push_back(std::move(c));
  for (test::BsdfCase& c : test::glossCases({0.f, 0.02f, 0.1f, 0.3f, 1.f})) cases.push_back(std::move(c));
  for (test::BsdfCase& c : test::coatedCases({0.f, 0.02f, 0.1f, 0.3f, 1.f})) cases.push_back(std::move(c));
  for (test::BsdfCase& c : cases) {
    c.diffuse = c.specular = c.transmittance = {1, 1, 1};
    for (const float cos_o : kCosines) {
      EXPECT_LE(bsdfAlbedo(c.bsdf(), cos_o).x, 1.001f) << c.name << " from " << cos_o;
      if (c.tables.model.alpha < 0.3f) continue;  // too sharp for these steps
      EXPECT_LE(integratedAlbedo(c, test::directionAt(cos_o)).x, 1.001) << c.name << " from " << cos_o;
    }
  }
}

// White diffuse, white plastic, a perfect mirror, clear glass from both sides: all that arrives leaves.
TEST(Furnace, ASurfaceWithoutLossReflectsAllLight) {
  std::vector<test::BsdfCase> cases;
  for (const BsdfKind kind : {BsdfKind::kDiffuse, BsdfKind::kPlastic, BsdfKind::kConductor,
                              BsdfKind::kDielectric, BsdfKind::kThinDielectric}) {
    BsdfModel m = test::modelOf(kind);
    cases.push_back({"kind " + std::to_string(static_cast<int>(kind)), BsdfTables(m), {1, 1, 1}});
    m.nonlinear = true, m.eta = {1, 1, 1}, m.k = {1e6f, 1e6f, 1e6f};
    cases.push_back({"variant of " + cases.back().name, BsdfTables(m), {1, 1, 1}});
  }
  for (const test::BsdfCase& c : cases) {
    for (const float cos_o : {0.05f, 0.2f, 0.6f, 1.f, -0.1f, -0.9f}) {
      const BsdfKind kind = c.tables.model.kind;
      if (cos_o < 0 && kind != BsdfKind::kDielectric && kind != BsdfKind::kThinDielectric) continue;
      expectNear(bsdfAlbedo(c.bsdf(), cos_o), {1, 1, 1}, 1e-3, c.name + " from " + std::to_string(cos_o));
      const Vec3d sampled = sampledAlbedo(c, test::directionAt(cos_o), 20000);
      expectNear({1, 1, 1}, sampled, 3e-3, c.name + ", sampled from " + std::to_string(cos_o));
    }
  }
}

}  // namespace
}  // namespace saccade
