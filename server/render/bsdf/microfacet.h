// Isotropic microfacet distributions with separable Smith masking, like Mitsuba's. Directions are in the
// shading frame; m is the normal of a microfacet.
#pragma once

#include "render/bsdf/beckmann.h"
#include "render/bsdf/sampling.h"
#include "scene/bsdf_model.h"

namespace saccade {

struct Microfacets {
  MicrofacetKind kind;
  float alpha;  // at least kLeastAlpha
};
inline constexpr float kLeastAlpha = 1e-4f;

// D: the area of microfacets of normal m, per area and solid angle [Walter 2007 (25), (33)].
inline float normalDensity(const Microfacets& f, Vec3 m) {
  const float cos2 = std::max(1e-12f, m.z * m.z), inv_alpha2 = 1 / (f.alpha * f.alpha);
  const float e = (m.x * m.x + m.y * m.y) * inv_alpha2;
  const float inv_shape =
      f.kind == MicrofacetKind::kGgx ? 1 / ((cos2 + e) * (cos2 + e)) : std::exp(-e / cos2) / (cos2 * cos2);
  return kInvPi * inv_alpha2 * inv_shape;
}

// G1: of the microfacets that face v, the fraction that is visible from v [Walter 2007 (34)]. Beckmann's is
// in closed form [Heitz 2014]. Mitsuba has a fit with an error of 0.4 %.
inline float visibleFraction(const Microfacets& f, Vec3 v) {
  const float slope = f.alpha * std::sqrt(v.x * v.x + v.y * v.y) / std::abs(v.z);
  if (f.kind == MicrofacetKind::kGgx) return 2 / (1 + std::sqrt(1 + slope * slope));
  const float a = 1 / std::max(1e-6f, slope);
  const float tail = std::exp(-a * a) * std::numbers::inv_sqrtpi_v<float> / a;
  return 2 / (2 + tail - std::erfc(a));
}

// Samples a normal that is visible from v at roughness 1. It has any length. It is a point of the visible cap
// [Dupuy and Benyoub 2023].
inline Vec3 sampleGgxNormal(Vec3 v, float u1, float u2) {
  const float height = (1 - u1) * (1 + v.z), z = height - v.z;
  const float r = std::sqrt(std::max(0.f, 1 - z * z)), phi = 2 * std::numbers::pi_v<float> * u2;
  return {v.x + r * std::cos(phi), v.y + r * std::sin(phi), height};
}

inline Vec3 sampleBeckmannNormal(Vec3 v, float u1, float u2) {
  const Slope s = sampleBeckmannSlope(v.z, u1, u2);
  const float sin_v = std::sqrt(v.x * v.x + v.y * v.y);
  const float cos_phi = sin_v > 0 ? v.x / sin_v : 1.f, sin_phi = sin_v > 0 ? v.y / sin_v : 0.f;
  return {sin_phi * s.y - cos_phi * s.x, -sin_phi * s.x - cos_phi * s.y, 1};
}

// Samples a unit normal with the density of visible normals, D G1 max(0, v.m) / v.z, for v.z > 0. The
// roughness becomes 1 where v is stretched, and the normal is stretched back [Heitz 2014].
inline Vec3 sampleVisibleNormal(const Microfacets& f, Vec3 v, float u1, float u2) {
  const Vec3 stretched = normalize(Vec3{f.alpha * v.x, f.alpha * v.y, std::max(1e-7f, v.z)});
  const Vec3 m = f.kind == MicrofacetKind::kGgx ? sampleGgxNormal(stretched, u1, u2)
                                                : sampleBeckmannNormal(stretched, u1, u2);
  return normalize(Vec3{f.alpha * m.x, f.alpha * m.y, m.z});
}

// The reflection of perfectly reflecting microfacets.
struct MicrofacetReflection {
  float value;  // f cos_i without Fresnel's factor
  float pdf;    // of reflecting off visible normals, per solid angle
  float cos_m;  // between either direction and the microfacet that reflects one into the other
};

// Requires wo.z > 0 and wi.z > 0 [Walter 2007 (20)].
inline MicrofacetReflection reflectOff(const Microfacets& f, Vec3 wo, Vec3 wi) {
  const Vec3 h = wo + wi;
  const Vec3 m = h / std::max(1e-12f, length(h));
  const float pdf = normalDensity(f, m) * visibleFraction(f, wo) / (4 * wo.z);
  return {pdf * visibleFraction(f, wi), pdf, std::clamp(dot(wo, m), 0.f, 1.f)};
}

}  // namespace saccade
