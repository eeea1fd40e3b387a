// Clear glass: a surface, or a pane. All is delta lobes.
#pragma once

#include "render/bsdf/bsdf_record.h"
#include "render/bsdf/fresnel.h"
#include "render/bsdf/sampling.h"

namespace saccade {

// Light in a straight line, from what is behind.
struct Transmittance {
  LaneRgb fraction{1, 1, 1};
  Lane probability = 1;
};

inline Lane reflectionProbability(const Bsdf& b, Lane f) {
  return lobeProbability(f * luminance(b.specular), (1 - f) * luminance(b.transmittance));
}

// Reflects a fraction f of light towards wo from mirror(wo), and lets 1 - f through from wt.
inline BsdfSample reflectOrTransmit(const Bsdf& b, LaneVec3 wo, LaneVec3 wt, Lane f, Lane u_lobe) {
  const Lane p = reflectionProbability(b, f);
  const LaneMask reflected = u_lobe < p;
  const Lane scale = select(reflected, f / p, (1 - f) / (1 - p));
  return {select(reflected, mirror(wo), wt),
          select(reflected, b.specular, b.transmittance) * select(wo.z != 0, scale, Lane(0)),
          select(reflected, p, 1 - p), true, !reflected};
}

inline LaneRgb reflectanceAndTransmittance(const Bsdf& b, Lane cos_o, Lane f) {
  return (b.specular * f + b.transmittance * (1 - f)) * select(cos_o != 0, Lane(1), Lane(0));
}

struct Dielectric {
  static constexpr BsdfKind kKind = BsdfKind::kDielectric;

  static BsdfValue evaluate(const Bsdf&, LaneVec3, LaneVec3) { return {}; }
  // The weight is of radiance, which grows with the square of the index of what it is in.
  static BsdfSample sample(const Bsdf& b, LaneVec3 wo, Lane u_lobe, Lane, Lane) {
    const Lane inv_ior = 1 / iorAcross(b, wo.z);
    const Refraction r = refraction(b, wo.z);
    const LaneVec3 wt{-wo.x * inv_ior, -wo.y * inv_ior, select(wo.z > 0, -r.cos_t, r.cos_t)};
    BsdfSample s = reflectOrTransmit(b, wo, wt, r.reflectance, u_lobe);
    s.weight = s.weight * select(s.transmitted, inv_ior * inv_ior, Lane(1));
    return s;
  }
  // Of power: without the change of radiance, which is undone where light leaves the glass.
  static LaneRgb albedo(const Bsdf& b, Lane cos_o) {
    return reflectanceAndTransmittance(b, cos_o, refraction(b, cos_o).reflectance);
  }

 private:
  // Index of the side that wo is not on, over that of its own.
  static Lane iorAcross(const Bsdf& b, Lane cos_o) {
    return select(cos_o > 0, b.tables->model.ior, 1 / b.tables->model.ior);
  }
  static Refraction refraction(const Bsdf& b, Lane cos_o) {
    return fresnelDielectric(std::min(Lane(1), std::abs(cos_o)), iorAcross(b, cos_o));
  }
};

struct ThinDielectric {
  static constexpr BsdfKind kKind = BsdfKind::kThinDielectric;

  static BsdfValue evaluate(const Bsdf&, LaneVec3, LaneVec3) { return {}; }
  static BsdfSample sample(const Bsdf& b, LaneVec3 wo, Lane u_lobe, Lane, Lane) {
    return reflectOrTransmit(b, wo, -wo, reflectance(b, wo.z), u_lobe);
  }
  static LaneRgb albedo(const Bsdf& b, Lane cos_o) {
    return reflectanceAndTransmittance(b, cos_o, reflectance(b, cos_o));
  }
  // What of light from behind goes straight through, and the probability that sample() finds it.
  static Transmittance passage(const Bsdf& b, Lane cos_o) {
    const Lane f = reflectance(b, cos_o);
    return {b.transmittance * (1 - f), 1 - reflectionProbability(b, f)};
  }

 private:
  // With all reflections inside the pane: f + (1-f)^2 f + (1-f)^2 f^3 + ... = 2 f / (1 + f).
  static Lane reflectance(const Bsdf& b, Lane cos_o) {
    const Lane f = fresnelDielectric(std::min(Lane(1), std::abs(cos_o)), b.tables->model.ior).reflectance;
    return 2 * f / (1 + f);
  }
};

}  // namespace saccade
