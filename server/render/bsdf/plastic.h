// A diffuse base under a dielectric interface, like Mitsuba's plastic and roughplastic. Light enters, and the
// base scatters it. The base scatters it again whenever the interface reflects it back:
//   f = f_interface + a / (1 - a R) T(cos_o) T(cos_i) / (pi ior^2).
// Without `nonlinear`, R replaces a R. R is the fraction of diffuse light from inside that stays inside: 1 -
// T inside, as in Mitsuba 0.6. Mitsuba 3 takes the reflectance of one bounce off the microfacets, which is a
// little less.
// With 1 - R = mean T / ior^2 the second part is
//   base T(cos_o) * T(cos_i) / (pi mean T),   base = a (1 - R) / (1 - a R), or a without `nonlinear`.
// Its albedo is base T(cos_o). A base that scatters once, as below Mitsuba's coatings, has a (1 - R).
#pragma once

#include "render/bsdf/bsdf_record.h"
#include "render/bsdf/fresnel.h"
#include "render/bsdf/microfacet.h"

namespace saccade {

// The fractions of light from outside that an interface reflects and transmits, in all directions together.
struct Interface {
  float reflectance, transmittance;
};

inline Rgb plasticBase(const Bsdf& b) {
  const float r = b.tables->internal_reflectance;
  const auto base = [r](float a) { return a * (1 - r) / (1 - a * r); };
  if (b.tables->model.scatters_once) return b.diffuse * (1 - r);
  return b.tables->model.nonlinear ? Rgb{base(b.diffuse.x), base(b.diffuse.y), base(b.diffuse.z)} : b.diffuse;
}

inline Rgb plasticAlbedo(const Bsdf& b, Interface o) {
  return b.specular * o.reflectance + plasticBase(b) * o.transmittance;
}

inline float specularProbability(const Bsdf& b, Interface o) {
  return lobeProbability(o.reflectance * luminance(b.specular), o.transmittance * luminance(plasticBase(b)));
}

inline Rgb diffusePart(const Bsdf& b, Interface o, Interface i, float cos_i) {
  return plasticBase(b) *
         (o.transmittance * i.transmittance * cosinePdf(cos_i) / b.tables->mean_transmittance);
}

struct Plastic {
  static constexpr BsdfKind kKind = BsdfKind::kPlastic;

  static BsdfValue evaluate(const Bsdf& b, Vec3 wo, Vec3 wi) {
    const Interface o = at(b, wo.z);  // its transmittance from below is 0
    return {diffusePart(b, o, at(b, wi.z), wi.z), (1 - specularProbability(b, o)) * cosinePdf(wi.z)};
  }
  static BsdfSample sample(const Bsdf& b, Vec3 wo, float u_lobe, float u1, float u2) {
    const Interface o = at(b, wo.z);
    const float p = specularProbability(b, o);
    const bool delta = u_lobe < p;
    const Vec3 wi = delta ? mirror(wo) : cosineHemisphere(u1, u2);
    const BsdfSample scattered = weigh(wi, evaluate(b, wo, wi));
    const Rgb reflected = b.specular * (wo.z > 0 ? o.reflectance / p : 0.f);
    return {wi, delta ? reflected : scattered.weight, delta ? p : scattered.pdf, delta, false};
  }
  static Rgb albedo(const Bsdf& b, float cos_o) {
    return plasticAlbedo(b, at(b, cos_o)) * (cos_o > 0 ? 1.f : 0.f);
  }
  static Rgb diffuseAlbedo(const Bsdf& b, float cos_o) {
    return plasticBase(b) * (cos_o > 0 ? at(b, cos_o).transmittance : 0.f);
  }

 private:
  static Interface at(const Bsdf& b, float cosine) {
    const float f = fresnelDielectric(std::clamp(cosine, 0.f, 1.f), b.tables->model.ior).reflectance;
    return {f, 1 - f};
  }
};

struct RoughPlastic {
  static constexpr BsdfKind kKind = BsdfKind::kRoughPlastic;

  static BsdfValue evaluate(const Bsdf& b, Vec3 wo, Vec3 wi) {
    const BsdfModel& m = b.tables->model;
    const Interface o = at(b, wo.z);
    const MicrofacetReflection r = reflectOff({m.microfacets, m.alpha}, wo, wi);
    const float p = specularProbability(b, o), f = fresnelDielectric(r.cos_m, m.ior).reflectance;
    const bool above = wo.z > 0 && wi.z > 0;
    return {
        b.specular * valueIf(above, f * r.value) + diffusePart(b, o, at(b, wi.z), wi.z) * valueIf(above, 1),
        valueIf(above, p * r.pdf + (1 - p) * cosinePdf(wi.z))};
  }
  static BsdfSample sample(const Bsdf& b, Vec3 wo, float u_lobe, float u1, float u2) {
    const BsdfModel& m = b.tables->model;
    const bool specular = u_lobe < specularProbability(b, at(b, wo.z));
    const Vec3 reflected = mirror(wo, sampleVisibleNormal({m.microfacets, m.alpha}, wo, u1, u2));
    const Vec3 wi = specular ? reflected : cosineHemisphere(u1, u2);
    return weigh(wi, evaluate(b, wo, wi));
  }
  static Rgb albedo(const Bsdf& b, float cos_o) {
    return plasticAlbedo(b, at(b, cos_o)) * (cos_o > 0 ? 1.f : 0.f);
  }
  static Rgb diffuseAlbedo(const Bsdf& b, float cos_o) {
    return plasticBase(b) * (cos_o > 0 ? at(b, cos_o).transmittance : 0.f);
  }

  static Interface at(const Bsdf& b, float cosine) {
    return {b.tables->reflectance(cosine).x, b.tables->transmittance(cosine)};
  }
};

}  // namespace saccade
