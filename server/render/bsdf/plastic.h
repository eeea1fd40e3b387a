// A diffuse base under a dielectric interface, as Mitsuba's plastic and roughplastic: light enters, is
// scattered by the base, and again whenever the interface sends it back:
//   f = f_interface + a / (1 - a R) T(cos_o) T(cos_i) / (pi ior^2),
// where a R is R for `nonlinear` false. R is what of diffuse light from inside does not come out: 1 - T
// inside, as in Mitsuba 0.6. (3 takes only what one bounce off the microfacets reflects, which is a little
// less.) With 1 - R = mean T / ior^2 the second part is
//   base T(cos_o) * T(cos_i) / (pi mean T),   base = a (1 - R) / (1 - a R), or a for `nonlinear` false,
// and base T(cos_o) its albedo.
#pragma once

#include "render/bsdf/bsdf_record.h"
#include "render/bsdf/fresnel.h"
#include "render/bsdf/microfacet.h"

namespace saccade {

// What an interface does with light from outside, in all directions together.
struct Interface {
  Lane reflectance, transmittance;
};

inline LaneRgb plasticBase(const Bsdf& b) {
  const Lane r = b.tables->internal_reflectance;
  const auto base = [r](Lane a) { return a * (1 - r) / (1 - a * r); };
  return b.tables->model.nonlinear ? LaneRgb{base(b.diffuse.x), base(b.diffuse.y), base(b.diffuse.z)}
                                   : b.diffuse;
}

inline LaneRgb plasticAlbedo(const Bsdf& b, Interface o) {
  return b.specular * o.reflectance + plasticBase(b) * o.transmittance;
}

inline Lane specularProbability(const Bsdf& b, Interface o) {
  return lobeProbability(o.reflectance * luminance(b.specular), o.transmittance * luminance(plasticBase(b)));
}

inline LaneRgb diffusePart(const Bsdf& b, Interface o, Interface i, Lane cos_i) {
  return plasticBase(b) *
         (o.transmittance * i.transmittance * cosinePdf(cos_i) / b.tables->mean_transmittance);
}

struct Plastic {
  static constexpr BsdfKind kKind = BsdfKind::kPlastic;

  static BsdfValue evaluate(const Bsdf& b, LaneVec3 wo, LaneVec3 wi) {
    const Interface o = at(b, wo.z);  // lets nothing through from below
    return {diffusePart(b, o, at(b, wi.z), wi.z), (1 - specularProbability(b, o)) * cosinePdf(wi.z)};
  }
  static BsdfSample sample(const Bsdf& b, LaneVec3 wo, Lane u_lobe, Lane u1, Lane u2) {
    const Interface o = at(b, wo.z);
    const Lane p = specularProbability(b, o);
    const LaneMask delta = u_lobe < p;
    const LaneVec3 wi = select(delta, mirror(wo), cosineHemisphere(u1, u2));
    const BsdfSample scattered = weigh(wi, evaluate(b, wo, wi));
    const LaneRgb reflected = b.specular * select(wo.z > 0, o.reflectance / p, Lane(0));
    return {wi, select(delta, reflected, scattered.weight), select(delta, p, scattered.pdf), delta, false};
  }
  static LaneRgb albedo(const Bsdf& b, Lane cos_o) {
    return plasticAlbedo(b, at(b, cos_o)) * select(cos_o > 0, Lane(1), Lane(0));
  }
  static LaneRgb diffuseAlbedo(const Bsdf& b, Lane cos_o) {
    return plasticBase(b) * select(cos_o > 0, at(b, cos_o).transmittance, Lane(0));
  }

 private:
  static Interface at(const Bsdf& b, Lane cosine) {
    const Lane f = fresnelDielectric(std::clamp(cosine, Lane(0), Lane(1)), b.tables->model.ior).reflectance;
    return {f, 1 - f};
  }
};

struct RoughPlastic {
  static constexpr BsdfKind kKind = BsdfKind::kRoughPlastic;

  static BsdfValue evaluate(const Bsdf& b, LaneVec3 wo, LaneVec3 wi) {
    const BsdfModel& m = b.tables->model;
    const Interface o = at(b, wo.z);
    const MicrofacetReflection r = reflectOff({m.microfacets, m.alpha}, wo, wi);
    const Lane p = specularProbability(b, o), f = fresnelDielectric(r.cos_m, m.ior).reflectance;
    const LaneMask above = wo.z > 0 && wi.z > 0;
    return {b.specular * select(above, f * r.value, Lane(0)) +
                diffusePart(b, o, at(b, wi.z), wi.z) * select(above, Lane(1), Lane(0)),
            select(above, p * r.pdf + (1 - p) * cosinePdf(wi.z), Lane(0))};
  }
  static BsdfSample sample(const Bsdf& b, LaneVec3 wo, Lane u_lobe, Lane u1, Lane u2) {
    const BsdfModel& m = b.tables->model;
    const LaneMask specular = u_lobe < specularProbability(b, at(b, wo.z));
    const LaneVec3 reflected = mirror(wo, sampleVisibleNormal({m.microfacets, m.alpha}, wo, u1, u2));
    const LaneVec3 wi = select(specular, reflected, cosineHemisphere(u1, u2));
    return weigh(wi, evaluate(b, wo, wi));
  }
  static LaneRgb albedo(const Bsdf& b, Lane cos_o) {
    return plasticAlbedo(b, at(b, cos_o)) * select(cos_o > 0, Lane(1), Lane(0));
  }
  static LaneRgb diffuseAlbedo(const Bsdf& b, Lane cos_o) {
    return plasticBase(b) * select(cos_o > 0, at(b, cos_o).transmittance, Lane(0));
  }

 private:
  static Interface at(const Bsdf& b, Lane cosine) {
    return {b.tables->reflectance(cosine).x, b.tables->transmittance(cosine)};
  }
};

}  // namespace saccade
