// Below the surface, along it, without roughness, without an interface: no light or finite light, and nothing
// that is not a number.
#include <gtest/gtest.h>

#include "render/bsdf_cases.h"

namespace saccade {
namespace {

constexpr float kCosines[] = {-1, -0.5f, -1e-4f, -1e-8f, -1e-20f, 0, 1e-20f, 1e-8f, 1e-4f, 0.5f, 1};
constexpr float kNumbers[] = {0, 0.3f, 1 - 0x1p-24f};  // the least and the most that a random number can be

bool isFinite(Vec3 v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Whether b gives light to a direction at this cosine.
bool canBeSeen(const test::BsdfCase& c, float cos_o) {
  const BsdfKind kind = c.tables.model.kind;
  const bool from_below = kind == BsdfKind::kDielectric || kind == BsdfKind::kThinDielectric;
  return cos_o > 0 || (cos_o < 0 && from_below);
}

std::vector<test::BsdfCase> cases() {
  std::vector<test::BsdfCase> all = test::smoothCases();
  for (test::BsdfCase& c : test::roughCases({0.f, 1e-3f, 1.f})) all.push_back(std::move(c));
  for (test::BsdfCase& c : test::metallicRoughnessCases({0.f, 0.03f, 1.f})) all.push_back(std::move(c));
  for (test::BsdfCase& c : test::glossCases({0.f, 1e-3f, 1.f})) all.push_back(std::move(c));
  for (test::BsdfCase& c : test::coatedCases({0.f, 1e-3f, 1.f})) all.push_back(std::move(c));
  all.push_back(test::metallicRoughness({0.5f, 0.5f, 0.5f}, 0.5f, 0, 1));
  all.push_back(test::metallicRoughness({}, 0.5f, 1));
  for (const BsdfKind kind :
       {BsdfKind::kDielectric, BsdfKind::kThinDielectric, BsdfKind::kPlastic, BsdfKind::kRoughPlastic,
        BsdfKind::kConductor, BsdfKind::kRoughConductor, BsdfKind::kCoatedConductor}) {
    BsdfModel same = test::modelOf(kind);
    same.ior = same.coat_ior = 1, same.eta = {1, 0, 0}, same.k = {0, 0, 0};
    all.push_back(
        {"no interface " + std::to_string(static_cast<int>(kind)), BsdfTables(same), {0.5f, 0.5f, 0.5f}});
  }
  return all;
}

TEST(DegenerateInput, HasAFiniteAlbedo) {
  for (const test::BsdfCase& c : cases()) {
    for (const float cos_o : kCosines) {
      const Rgb albedo = bsdfAlbedo(c.bsdf(), cos_o);
      ASSERT_TRUE(isFinite(albedo)) << c.name << ' ' << cos_o;
      ASSERT_TRUE(canBeSeen(c, cos_o) || albedo == Rgb()) << c.name << ' ' << cos_o;
    }
  }
}

TEST(DegenerateInput, HasAFiniteValue) {
  for (const test::BsdfCase& c : cases()) {
    for (const float cos_o : kCosines) {
      for (const float cos_i : kCosines) {
        const BsdfValue v =
            evaluateBsdf(c.bsdf(), test::directionAt(cos_o), test::directionAt(cos_i, 3.14159265f));
        ASSERT_TRUE(isFinite(v.value) && std::isfinite(v.pdf)) << c.name << ' ' << cos_o << ' ' << cos_i;
        ASSERT_TRUE((cos_o > 0 && cos_i > 0) || v.value == Rgb()) << c.name << ' ' << cos_o << ' ' << cos_i;
      }
    }
  }
}

void expectFiniteSamples(const test::BsdfCase& c, float cos_o, float u_lobe) {
  for (const float u1 : kNumbers) {
    for (const float u2 : kNumbers) {
      const BsdfSample s = sampleBsdf(c.bsdf(), test::directionAt(cos_o), u_lobe, u1, u2);
      ASSERT_TRUE(isFinite(s.weight) && std::isfinite(s.pdf)) << c.name << ' ' << cos_o;
      ASSERT_NEAR(length(s.wi), 1, 1e-4) << c.name << ' ' << cos_o;
      ASSERT_TRUE(canBeSeen(c, cos_o) || s.weight == Rgb()) << c.name << ' ' << cos_o;
    }
  }
}

TEST(DegenerateInput, HasFiniteSamples) {
  for (const test::BsdfCase& c : cases()) {
    for (const float cos_o : kCosines) {
      for (const float u_lobe : kNumbers) expectFiniteSamples(c, cos_o, u_lobe);
    }
  }
}

}  // namespace
}  // namespace saccade
