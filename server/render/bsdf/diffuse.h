// Lambert's reflector.
#pragma once

#include "render/bsdf/bsdf_record.h"
#include "render/bsdf/sampling.h"

namespace saccade {

struct Diffuse {
  static constexpr BsdfKind kKind = BsdfKind::kDiffuse;

  static BsdfValue evaluate(const Bsdf& b, Vec3 wo, Vec3 wi) {
    const float pdf = wo.z > 0 ? cosinePdf(wi.z) : 0.f;
    return {b.diffuse * pdf, pdf};
  }
  static BsdfSample sample(const Bsdf& b, Vec3 wo, float, float u1, float u2) {
    const Vec3 wi = cosineHemisphere(u1, u2);
    const float above = wo.z > 0 ? 1.f : 0.f;
    return {wi, b.diffuse * above, cosinePdf(wi.z) * above, false, false};
  }
  static Rgb albedo(const Bsdf& b, float cos_o) { return b.diffuse * (cos_o > 0 ? 1.f : 0.f); }
  static Rgb diffuseAlbedo(const Bsdf& b, float cos_o) { return albedo(b, cos_o); }
};

}  // namespace saccade
