// Lambert's reflector.
#pragma once

#include "render/bsdf/bsdf_record.h"
#include "render/bsdf/sampling.h"

namespace saccade {

struct Diffuse {
  static constexpr BsdfKind kKind = BsdfKind::kDiffuse;

  static BsdfValue evaluate(const Bsdf& b, LaneVec3 wo, LaneVec3 wi) {
    const Lane pdf = select(wo.z > 0, cosinePdf(wi.z), Lane(0));
    return {b.diffuse * pdf, pdf};
  }
  static BsdfSample sample(const Bsdf& b, LaneVec3 wo, Lane, Lane u1, Lane u2) {
    const LaneVec3 wi = cosineHemisphere(u1, u2);
    const Lane above = select(wo.z > 0, Lane(1), Lane(0));
    return {wi, b.diffuse * above, cosinePdf(wi.z) * above, false, false};
  }
  static LaneRgb albedo(const Bsdf& b, Lane cos_o) { return b.diffuse * select(cos_o > 0, Lane(1), Lane(0)); }
  static LaneRgb diffuseAlbedo(const Bsdf& b, Lane cos_o) { return albedo(b, cos_o); }
};

}  // namespace saccade
