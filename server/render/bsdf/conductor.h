// Metals. A smooth one may have a dielectric coat, as in Mitsuba. The coat lets light through down and up,
// and the metal reflects it once.
#pragma once

#include "render/bsdf/bsdf_record.h"
#include "render/bsdf/fresnel.h"
#include "render/bsdf/microfacet.h"

namespace saccade {

struct Conductor {
  static constexpr BsdfKind kKind = BsdfKind::kConductor;

  static BsdfValue evaluate(const Bsdf&, Vec3, Vec3) { return {}; }
  static BsdfSample sample(const Bsdf& b, Vec3 wo, float, float, float) {
    return {mirror(wo), albedo(b, wo.z), 1, true, false};
  }
  static Rgb albedo(const Bsdf& b, float cos_o) {
    if (!(cos_o > 0)) return {};
    const BsdfModel& m = b.tables->model;
    const float cosine = std::min(cos_o, 1.f);
    if (m.coat_ior == 0) return b.specular * fresnelConductor(cosine, m.eta, m.k);
    const auto [coat, inner] = fresnelDielectric(cosine, m.coat_ior);
    return Rgb{coat, coat, coat} +
           b.specular * fresnelConductor(inner, m.eta, m.k) * ((1 - coat) * (1 - coat));
  }
};

struct RoughConductor {
  static constexpr BsdfKind kKind = BsdfKind::kRoughConductor;

  static BsdfValue evaluate(const Bsdf& b, Vec3 wo, Vec3 wi) {
    const BsdfModel& m = b.tables->model;
    const MicrofacetReflection r = reflectOff({m.microfacets, m.alpha}, wo, wi);
    const bool above = wo.z > 0 && wi.z > 0;
    return {b.specular * fresnelConductor(r.cos_m, m.eta, m.k) * valueIf(above, r.value),
            valueIf(above, r.pdf)};
  }
  static BsdfSample sample(const Bsdf& b, Vec3 wo, float, float u1, float u2) {
    const BsdfModel& m = b.tables->model;
    const Vec3 wi = mirror(wo, sampleVisibleNormal({m.microfacets, m.alpha}, wo, u1, u2));
    return weigh(wi, evaluate(b, wo, wi));
  }
  static Rgb albedo(const Bsdf& b, float cos_o) {
    return b.specular * b.tables->reflectance(cos_o) * (cos_o > 0 ? 1.f : 0.f);
  }
};

}  // namespace saccade
