// Clear glass: a surface, or a pane. It has delta lobes only.
#pragma once

#include "render/bsdf/bsdf_record.h"
#include "render/bsdf/fresnel.h"
#include "render/bsdf/sampling.h"

namespace saccade {

// Light from behind that goes straight through.
struct Transmittance {
  Rgb fraction{1, 1, 1};
  float probability = 1;
};

inline float reflectionProbability(const Bsdf& b, float f) {
  return lobeProbability(f * luminance(b.specular), (1 - f) * luminance(b.transmittance));
}

// Reflects a fraction f of the light towards wo from mirror(wo), and transmits 1 - f from wt.
inline BsdfSample reflectOrTransmit(const Bsdf& b, Vec3 wo, Vec3 wt, float f, float u_lobe) {
  const float p = reflectionProbability(b, f);
  const bool reflected = u_lobe < p;
  const float scale = reflected ? f / p : (1 - f) / (1 - p);
  return {reflected ? mirror(wo) : wt, (reflected ? b.specular : b.transmittance) * (wo.z != 0 ? scale : 0.f),
          reflected ? p : 1 - p, true, !reflected};
}

inline Rgb reflectanceAndTransmittance(const Bsdf& b, float cos_o, float f) {
  return (b.specular * f + b.transmittance * (1 - f)) * (cos_o != 0 ? 1.f : 0.f);
}

struct Dielectric {
  static constexpr BsdfKind kKind = BsdfKind::kDielectric;

  static BsdfValue evaluate(const Bsdf&, Vec3, Vec3) { return {}; }
  // The weight is of radiance. Radiance is proportional to the square of the medium's index of refraction.
  static BsdfSample sample(const Bsdf& b, Vec3 wo, float u_lobe, float, float) {
    const float inv_ior = 1 / iorAcross(b, wo.z);
    const Refraction r = refraction(b, wo.z);
    const Vec3 wt{-wo.x * inv_ior, -wo.y * inv_ior, wo.z > 0 ? -r.cos_t : r.cos_t};
    BsdfSample s = reflectOrTransmit(b, wo, wt, r.reflectance, u_lobe);
    s.weight = s.weight * (s.transmitted ? inv_ior * inv_ior : 1.f);
    return s;
  }
  // The albedo is of power. It leaves out the change of radiance, which ends where light leaves the glass.
  static Rgb albedo(const Bsdf& b, float cos_o) {
    return reflectanceAndTransmittance(b, cos_o, refraction(b, cos_o).reflectance);
  }

 private:
  // The index of refraction of the side opposite to wo, over that of the side of wo.
  static float iorAcross(const Bsdf& b, float cos_o) {
    return cos_o > 0 ? b.tables->model.ior : 1 / b.tables->model.ior;
  }
  static Refraction<float> refraction(const Bsdf& b, float cos_o) {
    return fresnelDielectric(std::min(1.f, std::abs(cos_o)), iorAcross(b, cos_o));
  }
};

struct ThinDielectric {
  static constexpr BsdfKind kKind = BsdfKind::kThinDielectric;

  static BsdfValue evaluate(const Bsdf&, Vec3, Vec3) { return {}; }
  static BsdfSample sample(const Bsdf& b, Vec3 wo, float u_lobe, float, float) {
    return reflectOrTransmit(b, wo, -wo, reflectance(b, wo.z), u_lobe);
  }
  static Rgb albedo(const Bsdf& b, float cos_o) {
    return reflectanceAndTransmittance(b, cos_o, reflectance(b, cos_o));
  }
  // The fraction of light from behind that goes straight through, and the probability that sample() chooses
  // it.
  static Transmittance straightTransmittance(const Bsdf& b, float cos_o) {
    const float f = reflectance(b, cos_o);
    return {b.transmittance * (1 - f), 1 - reflectionProbability(b, f)};
  }

 private:
  // The sum of all reflections inside the pane: f + (1-f)^2 f + (1-f)^2 f^3 + ... = 2 f / (1 + f).
  static float reflectance(const Bsdf& b, float cos_o) {
    const float f = fresnelDielectric(std::min(1.f, std::abs(cos_o)), b.tables->model.ior).reflectance;
    return 2 * f / (1 + f);
  }
};

}  // namespace saccade
