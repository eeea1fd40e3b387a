// Rough glass: a dielectric interface of microfacets, each of which reflects and refracts [Walter 2007].
#pragma once

#include "render/bsdf/bsdf_record.h"
#include "render/bsdf/dielectric.h"
#include "render/bsdf/microfacet.h"

namespace saccade {

struct RoughDielectric {
  static constexpr BsdfKind kKind = BsdfKind::kRoughDielectric;

  static BsdfValue evaluate(const Bsdf& b, Vec3 wo, Vec3 wi) {
    const Side side(b, wo);
    const Vec3 v = side.seen(wo), l = side.seen(wi);
    if (!(v.z > 0)) return {};
    return l.z > 0 ? reflect(b, side, v, l) : l.z < 0 ? refract(b, side, v, l) : BsdfValue{};
  }

  static BsdfSample sample(const Bsdf& b, Vec3 wo, float u_lobe, float u1, float u2) {
    const Side side(b, wo);
    const Vec3 v = side.seen(wo);
    const Vec3 m = sampleVisibleNormal(side.facets, v, u1, u2);
    const float cos_m = std::clamp(dot(v, m), 0.f, 1.f);
    const Refraction f = fresnelDielectric(cos_m, side.ior);
    const bool reflected = u_lobe < reflectionProbability(b, f.reflectance);
    const Vec3 l = reflected ? mirror(v, m) : normalize(m * (cos_m / side.ior - f.cos_t) - v / side.ior);
    const Vec3 wi = side.seen(l);
    const bool right_side = v.z > 0 && (reflected ? l.z > 0 : l.z < 0);
    BsdfSample s = weigh(wi, right_side ? evaluate(b, wo, wi) : BsdfValue{});
    s.transmitted = !reflected;
    return s;
  }

  // Of power, as that of smooth glass.
  static Rgb albedo(const Bsdf& b, float cos_o) {
    const BsdfTables& t = *b.tables;
    if (cos_o == 0) return {};
    if (cos_o > 0) return b.specular * t.reflectance(cos_o).x + b.transmittance * t.transmittance(cos_o);
    return b.specular * t.inner_reflectance(-cos_o) + b.transmittance * t.inner_transmittance(-cos_o);
  }

 private:
  // The interface as seen from the side of wo, with the normal on that side.
  struct Side {
    Side(const Bsdf& b, Vec3 wo)
        : facets{b.tables->model.microfacets, b.tables->model.alpha},
          ior(wo.z > 0 ? b.tables->model.ior : 1 / b.tables->model.ior),
          sign(wo.z > 0 ? 1.f : -1.f) {}
    Vec3 seen(Vec3 w) const { return w * sign; }  // and back

    Microfacets facets;
    float ior;  // of the other side over this one
    float sign;
  };

  static BsdfValue reflect(const Bsdf& b, const Side& side, Vec3 v, Vec3 l) {
    const MicrofacetReflection r = reflectOff(side.facets, v, l);
    const float f = fresnelDielectric(r.cos_m, side.ior).reflectance;
    return {b.specular * (f * r.value), reflectionProbability(b, f) * r.pdf};
  }

  // [Walter 2007 (16), (17), (21)] for radiance, which changes with the square of the index. So the factor
  // ior^2 of (21) is left out.
  static BsdfValue refract(const Bsdf& b, const Side& side, Vec3 v, Vec3 l) {
    const Vec3 h = v + l * side.ior;
    const Vec3 up = h.z < 0 ? -h : h;
    const Vec3 m = up / std::max(1e-12f, length(up));
    const float v_m = dot(v, m), l_m = dot(l, m), sum = v_m + side.ior * l_m;
    if (!(v_m > 0 && l_m < 0 && sum * sum > 0)) return {};
    const float f = fresnelDielectric(std::min(1.f, v_m), side.ior).reflectance;
    const float density =
        normalDensity(side.facets, m) * visibleFraction(side.facets, v) * v_m * -l_m / (v.z * sum * sum);
    return {b.transmittance * ((1 - f) * density * visibleFraction(side.facets, l)),
            (1 - reflectionProbability(b, f)) * density * side.ior * side.ior};
  }
};

}  // namespace saccade
