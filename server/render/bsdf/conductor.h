// Metals.
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
    const Rgb f = fresnelConductor(std::clamp(cos_o, 0.f, 1.f), b.tables->model.eta, b.tables->model.k);
    return b.specular * f * (cos_o > 0 ? 1.f : 0.f);
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
