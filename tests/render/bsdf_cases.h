// Materials and directions that BSDFs are tested with.
#pragma once

#include <string>
#include <vector>

#include "base/hash_rng.h"
#include "render/bsdf/bsdf.h"

namespace saccade::test {

struct BsdfCase {
  std::string name;
  BsdfTables tables;
  Rgb diffuse{}, specular{1, 1, 1}, transmittance{1, 1, 1};
  float alpha = 1;

  Bsdf bsdf() const { return {&tables, diffuse, specular, transmittance, alpha}; }
};

inline BsdfModel modelOf(BsdfKind kind) {
  BsdfModel m;
  m.kind = kind;
  return m;
}

inline BsdfModel roughModel(BsdfKind kind, MicrofacetKind microfacets, float alpha) {
  BsdfModel m = modelOf(kind);
  m.microfacets = microfacets;
  m.alpha = alpha;
  return m;
}

// Rough metal that reflects what reaches it, and rough plastic, white and coloured, of either distribution.
inline std::vector<BsdfCase> roughCases(std::vector<float> alphas) {
  std::vector<BsdfCase> cases;
  for (const MicrofacetKind kind : {MicrofacetKind::kBeckmann, MicrofacetKind::kGgx}) {
    for (const float alpha : alphas) {
      const std::string name = (kind == MicrofacetKind::kGgx ? "ggx " : "beckmann ") + std::to_string(alpha);
      BsdfModel metal = roughModel(BsdfKind::kRoughConductor, kind, alpha);
      cases.push_back({"loss-free rough conductor, " + name, BsdfTables(metal)});
      metal.eta = {0.2f, 0.92f, 1.1f}, metal.k = {3.9f, 2.45f, 2.14f};
      cases.push_back({"rough copper, " + name, BsdfTables(metal), {}, {0.9f, 0.8f, 0.7f}});
      BsdfModel plastic = roughModel(BsdfKind::kRoughPlastic, kind, alpha);
      cases.push_back(
          {"rough plastic, " + name, BsdfTables(plastic), {0.8f, 0.4f, 0.1f}, {0.5f, 0.6f, 0.7f}});
      plastic.nonlinear = true;
      cases.push_back({"white rough plastic, " + name, BsdfTables(plastic), {1, 1, 1}});
    }
  }
  return cases;
}

inline BsdfCase metallicRoughness(Rgb base, float roughness, float metalness, float ior = 1.5f) {
  BsdfModel model = modelOf(BsdfKind::kMetallicRoughness);
  model.ior = ior;
  BsdfCase c{"metallic-roughness " + std::to_string(roughness) + " " + std::to_string(metalness) +
                 " of index " + std::to_string(ior),
             BsdfTables(model)};
  const Bsdf b = MetallicRoughness::at(c.tables, base, {0, roughness, metalness});
  c.diffuse = b.diffuse, c.specular = b.specular, c.alpha = b.alpha;
  return c;
}

// Of each roughness a dielectric, a mixture and a metal.
inline std::vector<BsdfCase> metallicRoughnessCases(std::vector<float> roughnesses) {
  std::vector<BsdfCase> cases;
  for (const float roughness : roughnesses)
    for (const float metalness : {0.f, 0.5f, 1.f})
      cases.push_back(metallicRoughness({0.9f, 0.5f, 0.2f}, roughness, metalness));
  return cases;
}

// Phong and Ward, with a base that the gloss leaves alone, and one that it takes light from.
inline std::vector<BsdfCase> glossCases(std::vector<float> alphas) {
  std::vector<BsdfCase> cases;
  for (const float alpha : alphas)
    for (const BsdfKind kind : {BsdfKind::kPhong, BsdfKind::kWard}) {
      const BsdfModel model = roughModel(kind, MicrofacetKind::kBeckmann, alpha);
      const std::string name = traitsOf(kind).name + (" " + std::to_string(alpha));
      cases.push_back({name, BsdfTables(model), {0.5f, 0.3f, 0.1f}, {0.3f, 0.4f, 0.5f}});
      cases.push_back({"bright " + name, BsdfTables(model), {0.9f, 0.8f, 0.7f}, {0.5f, 0.5f, 0.9f}});
    }
  return cases;
}

// Rough copper under a smooth coat, and under one of the same roughness and the other distribution.
inline std::vector<BsdfCase> coatedCases(std::vector<float> alphas) {
  std::vector<BsdfCase> cases;
  for (const float alpha : alphas) {
    BsdfModel m = roughModel(BsdfKind::kCoatedConductor, MicrofacetKind::kGgx, alpha);
    m.eta = {0.2f, 0.92f, 1.1f}, m.k = {3.9f, 2.45f, 2.14f}, m.coat_ior = 1.5f;
    const std::string name = "coat over rough copper " + std::to_string(alpha);
    cases.push_back({"smooth " + name, BsdfTables(m), {}, {0.9f, 0.8f, 0.7f}});
    m.coat_alpha = alpha, m.coat_microfacets = MicrofacetKind::kBeckmann;
    cases.push_back({"rough " + name, BsdfTables(m), {}, {0.9f, 0.8f, 0.7f}});
  }
  return cases;
}

inline std::vector<BsdfCase> smoothCases() {
  BsdfModel metal = modelOf(BsdfKind::kConductor), nonlinear = modelOf(BsdfKind::kPlastic), coat = nonlinear;
  metal.eta = {0.2f, 0.92f, 1.1f}, metal.k = {3.9f, 2.45f, 2.14f};
  nonlinear.nonlinear = coat.scatters_once = true;
  BsdfModel coated = metal;
  coated.coat_ior = 1.5f;
  return {{"diffuse", BsdfTables(modelOf(BsdfKind::kDiffuse)), {0.8f, 0.4f, 0.1f}},
          {"plastic", BsdfTables(modelOf(BsdfKind::kPlastic)), {0.8f, 0.4f, 0.1f}, {0.5f, 0.6f, 0.7f}},
          {"nonlinear plastic", BsdfTables(nonlinear), {0.8f, 0.4f, 0.1f}},
          {"coat over diffuse", BsdfTables(coat), {0.8f, 0.4f, 0.1f}},
          {"copper", BsdfTables(metal), {}, {0.9f, 0.8f, 0.7f}},
          {"coat over copper", BsdfTables(coated), {}, {0.9f, 0.8f, 0.7f}},
          {"dielectric", BsdfTables(modelOf(BsdfKind::kDielectric)), {}, {0.5f, 0.6f, 0.7f}, {0.9f, 0.8f, 0}},
          {"pane", BsdfTables(modelOf(BsdfKind::kThinDielectric)), {}, {0.5f, 0.6f, 0.7f}, {0.9f, 0.8f, 0}}};
}

// The unit vector at cosine cos_n with the normal and azimuth phi.
inline Vec3 directionAt(double cos_n, double phi = 0) {
  const double sin_n = std::sqrt(std::max(0.0, 1 - cos_n * cos_n));
  return toFloat({sin_n * std::cos(phi), sin_n * std::sin(phi), cos_n});
}

// The i-th uniform number in [0, 1) of a seed.
inline float uniformAt(std::uint64_t seed, std::uint64_t i) {
  return toUnit(hashKey(seed, i));
}

// The i-th sample of b for wo.
inline BsdfSample sampleAt(const Bsdf& b, Vec3 wo, std::uint64_t i) {
  return sampleBsdf(b, wo, uniformAt(1, i), uniformAt(2, i), uniformAt(3, i));
}

}  // namespace saccade::test
