// The metallic-roughness material of glTF 2.0 [appendix B]. GGX microfacets of alpha = roughness^2 reflect by
// Schlick's formula. At a right angle they reflect the base colour where the surface is a metal, and what the
// index of refraction says elsewhere. There the base below scatters what they let through:
//   f = F D G / (4 cos_o cos_i) + (1 - metalness) base T(cos_o) T(cos_i) / (pi mean T).
// T is 1 less what the microfacets of what is no metal reflect, in all directions together.
// The appendix leaves the coupling open, and its simple one reflects more than it gets. This one does not,
// and is reciprocal [Kelemen and Szirmay-Kalos 2001].
#pragma once

#include "render/bsdf/bsdf_record.h"
#include "render/bsdf/microfacet.h"

namespace saccade {

struct MetallicRoughness {
  static constexpr BsdfKind kKind = BsdfKind::kMetallicRoughness;

  // At a point with these colours, in [0, 1]; see Material::metallic_roughness.
  static Bsdf at(const BsdfTables& tables, Rgb base, Rgb metallic_roughness) {
    const float metalness = metallic_roughness.z, rest = 1 - metalness;
    const Rgb dielectric = Rgb{1, 1, 1} * tables.dielectric_reflectance;
    Bsdf b{&tables, base * rest, dielectric * rest + base * metalness};
    b.alpha = std::max(metallic_roughness.y * metallic_roughness.y, kLeastAlpha);
    return b;
  }

  static BsdfValue evaluate(const Bsdf& b, Vec3 wo, Vec3 wi) {
    if (!(wo.z > 0 && wi.z > 0)) return {};
    const MicrofacetReflection r = reflectOff(microfacets(b), wo, wi);
    const SchlickAlbedo o = albedoAt(b, wo.z);
    const float p = specularProbability(b, o), cosine = cosinePdf(wi.z);
    const float base = transmitted(b, o) * transmitted(b, albedoAt(b, wi.z)) * cosine /
                       transmitted(b, b.tables->schlick->mean(b.alpha));
    const float x = 1 - r.cos_m, fifth = x * x * x * x * x;
    const Rgb fresnel = reflected(b, {1 - fifth, fifth});
    return {fresnel * r.value + b.diffuse * base, p * r.pdf + (1 - p) * cosine};
  }
  static BsdfSample sample(const Bsdf& b, Vec3 wo, float u_lobe, float u1, float u2) {
    const bool specular = u_lobe < specularProbability(b, albedoAt(b, wo.z));
    const Vec3 wi =
        specular ? mirror(wo, sampleVisibleNormal(microfacets(b), wo, u1, u2)) : cosineHemisphere(u1, u2);
    return weigh(wi, evaluate(b, wo, wi));
  }
  static Rgb albedo(const Bsdf& b, float cos_o) {
    return cos_o > 0 ? reflected(b, albedoAt(b, cos_o)) + diffuseAlbedo(b, cos_o) : Rgb{};
  }
  static Rgb diffuseAlbedo(const Bsdf& b, float cos_o) {
    return cos_o > 0 ? b.diffuse * transmitted(b, albedoAt(b, cos_o)) : Rgb{};
  }
  static bool hasBase(const Bsdf& b) { return luminance(b.diffuse) > luminance(b.specular); }

 private:
  static Microfacets microfacets(const Bsdf& b) { return {MicrofacetKind::kGgx, b.alpha}; }
  // The reflectance at grazing angles: 1 of metals, and that of the interface of what is none. A mixture has
  // the least of the values that its colour allows, so that it does not reflect more than it gets.
  static float grazing(const Bsdf& b) {
    const float f0 = b.tables->dielectric_reflectance, f90 = grazingReflectance(f0);
    const float most = std::max({b.specular.x, b.specular.y, b.specular.z});
    return most > 0 ? f90 + (1 - f90) * std::max(0.f, (most - f0) / (1 - f0)) : 0;
  }
  // The fraction of light that the microfacets reflect, in all directions together.
  static Rgb reflected(const Bsdf& b, SchlickAlbedo a) {
    const float at_grazing = grazing(b) * a.grazing;
    return b.specular * a.normal + Rgb{at_grazing, at_grazing, at_grazing};
  }
  // And that those of what is no metal let through.
  static float transmitted(const Bsdf& b, SchlickAlbedo a) {
    const float f0 = b.tables->dielectric_reflectance;
    return 1 - f0 * a.normal - grazingReflectance(f0) * a.grazing;
  }
  static SchlickAlbedo albedoAt(const Bsdf& b, float cosine) {
    return b.tables->schlick->at(b.alpha, cosine);
  }

  static float specularProbability(const Bsdf& b, SchlickAlbedo o) {
    return lobeProbability(luminance(reflected(b, o)), luminance(b.diffuse) * transmitted(b, o));
  }
};

}  // namespace saccade
