// A rough metal under a dielectric coat, as coating and roughcoating of Mitsuba 0.6 [Weidlich and Wilkie
// 2007]:
//   f = f_coat(o, i) + T(o) T(i) / ior^2 f_metal(o', i').
// The coat bends o and i to o' and i' as if it were flat. Light that it sends back down to the metal is lost.
// A smooth coat is a mirror beside the metal, and a rough one has microfacets.
#pragma once

#include "render/bsdf/bsdf_record.h"
#include "render/bsdf/fresnel.h"
#include "render/bsdf/microfacet.h"

namespace saccade {

// w in the coat, for w.z > 0. The index is at least 1, so that w does not come nearer to the horizon.
inline Vec3 enterCoat(Vec3 w, float ior) {
  return {w.x / ior, w.y / ior, std::max(w.z, fresnelDielectric(std::min(w.z, 1.f), ior).cos_t)};
}
// Out of the coat; below the surface where w does not leave it.
inline Vec3 leaveCoat(Vec3 w, float ior) {
  const float x = w.x * ior, y = w.y * ior, sin2 = x * x + y * y;
  return w.z > 0 && sin2 < 1 ? Vec3{x, y, std::sqrt(1 - sin2)} : Vec3{w.x, w.y, -std::abs(w.z)};
}

inline bool hasRoughCoat(const BsdfTables& t) {
  return t.model.coat_alpha > 0;
}
// The fraction of light from a cosine, at least 0, that the coat reflects and that it lets through.
inline float coatReflectance(const BsdfTables& t, float cosine) {
  return hasRoughCoat(t) ? t.coat_reflectance(cosine)
                         : fresnelDielectric(std::min(cosine, 1.f), t.model.coat_ior).reflectance;
}
inline float coatTransmittance(const BsdfTables& t, float cosine) {
  return hasRoughCoat(t) ? t.transmittance(cosine) : 1 - coatReflectance(t, cosine);
}

struct CoatedConductor {
  static constexpr BsdfKind kKind = BsdfKind::kCoatedConductor;

  static BsdfValue evaluate(const Bsdf& b, Vec3 wo, Vec3 wi) {
    if (!(wo.z > 0 && wi.z > 0)) return {};
    const float p = coatProbability(b, wo.z);
    const BsdfValue metal = evaluateMetal(b, wo, wi), coat = evaluateCoat(b, wo, wi);
    return {metal.value + coat.value, (1 - p) * metal.pdf + p * coat.pdf};
  }
  static BsdfSample sample(const Bsdf& b, Vec3 wo, float u_lobe, float u1, float u2) {
    const BsdfTables& t = *b.tables;
    const float p = coatProbability(b, wo.z);
    const bool coat = u_lobe < p;
    if (coat && !hasRoughCoat(t)) {
      const float weight = wo.z > 0 ? coatReflectance(t, wo.z) / p : 0;
      return {mirror(wo), {weight, weight, weight}, p, true, false};
    }
    const Vec3 from = coat ? wo : enterCoat(wo, t.model.coat_ior);
    const Vec3 to = mirror(from, sampleVisibleNormal(coat ? coatFacets(t) : metalFacets(t), from, u1, u2));
    const Vec3 wi = coat ? to : leaveCoat(to, t.model.coat_ior);
    return weigh(wi, evaluate(b, wo, wi));
  }
  static Rgb albedo(const Bsdf& b, float cos_o) {
    if (!(cos_o > 0)) return {};
    const float coat = coatReflectance(*b.tables, cos_o);
    return Rgb{coat, coat, coat} + metalAlbedo(b, cos_o);
  }

 private:
  static Microfacets metalFacets(const BsdfTables& t) { return {t.model.microfacets, t.model.alpha}; }
  static Microfacets coatFacets(const BsdfTables& t) {
    return {t.model.coat_microfacets, t.model.coat_alpha};
  }

  static float coatProbability(const Bsdf& b, float cos_o) {
    const float cosine = std::max(cos_o, 0.f);
    return lobeProbability(coatReflectance(*b.tables, cosine), luminance(metalAlbedo(b, cosine)));
  }
  static Rgb metalAlbedo(const Bsdf& b, float cosine) {
    return b.specular * b.tables->reflectance(cosine) * coatTransmittance(*b.tables, cosine);
  }

  static BsdfValue evaluateCoat(const Bsdf& b, Vec3 wo, Vec3 wi) {
    if (!hasRoughCoat(*b.tables)) return {};
    const MicrofacetReflection r = reflectOff(coatFacets(*b.tables), wo, wi);
    const float value = r.value * fresnelDielectric(r.cos_m, b.tables->model.coat_ior).reflectance;
    return {{value, value, value}, r.pdf};
  }

  // A solid angle in the coat is cos_i / (ior^2 cos_i') of that outside.
  static BsdfValue evaluateMetal(const Bsdf& b, Vec3 wo, Vec3 wi) {
    const BsdfTables& t = *b.tables;
    const BsdfModel& m = t.model;
    const Vec3 inner = enterCoat(wi, m.coat_ior);
    const MicrofacetReflection r = reflectOff(metalFacets(t), enterCoat(wo, m.coat_ior), inner);
    const float angle = wi.z / (m.coat_ior * m.coat_ior * inner.z);
    const float through = coatTransmittance(t, wo.z) * coatTransmittance(t, wi.z);
    return {b.specular * fresnelConductor(r.cos_m, m.eta, m.k) * (through * r.value * angle), r.pdf * angle};
  }
};

}  // namespace saccade
