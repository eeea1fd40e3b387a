// Metals.
#pragma once

#include "render/bsdf/bsdf_record.h"
#include "render/bsdf/fresnel.h"
#include "render/bsdf/microfacet.h"

namespace saccade {

struct Conductor {
  static constexpr BsdfKind kKind = BsdfKind::kConductor;

  static BsdfValue evaluate(const Bsdf&, LaneVec3, LaneVec3) { return {}; }
  static BsdfSample sample(const Bsdf& b, LaneVec3 wo, Lane, Lane, Lane) {
    return {mirror(wo), albedo(b, wo.z), 1, true, false};
  }
  static LaneRgb albedo(const Bsdf& b, Lane cos_o) {
    const LaneRgb f =
        fresnelConductor(std::clamp(cos_o, Lane(0), Lane(1)), b.tables->model.eta, b.tables->model.k);
    return b.specular * f * select(cos_o > 0, Lane(1), Lane(0));
  }
};

struct RoughConductor {
  static constexpr BsdfKind kKind = BsdfKind::kRoughConductor;

  static BsdfValue evaluate(const Bsdf& b, LaneVec3 wo, LaneVec3 wi) {
    const BsdfModel& m = b.tables->model;
    const MicrofacetReflection r = reflectOff({m.microfacets, m.alpha}, wo, wi);
    const LaneMask above = wo.z > 0 && wi.z > 0;
    return {b.specular * fresnelConductor(r.cos_m, m.eta, m.k) * select(above, r.value, Lane(0)),
            select(above, r.pdf, Lane(0))};
  }
  static BsdfSample sample(const Bsdf& b, LaneVec3 wo, Lane, Lane u1, Lane u2) {
    const BsdfModel& m = b.tables->model;
    const LaneVec3 wi = mirror(wo, sampleVisibleNormal({m.microfacets, m.alpha}, wo, u1, u2));
    return weigh(wi, evaluate(b, wo, wi));
  }
  static LaneRgb albedo(const Bsdf& b, Lane cos_o) {
    return b.specular * b.tables->reflectance(cos_o) * select(cos_o > 0, Lane(1), Lane(0));
  }
};

}  // namespace saccade
