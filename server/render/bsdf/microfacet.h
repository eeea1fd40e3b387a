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

// GGX, for floats and for lanes. normalDensity(), visibleFraction() and sampleVisibleNormal() say what these
// are.
template <class F>
F ggxDensity(F alpha, Vec3T<F> m) {
  using std::max;
  const F cos2 = max(F(1e-12f), m.z * m.z), inv_alpha2 = 1.f / (alpha * alpha);
  const F sum = cos2 + (m.x * m.x + m.y * m.y) * inv_alpha2;
  return kInvPi * inv_alpha2 / (sum * sum);
}
template <class F>
F ggxVisible(F alpha, Vec3T<F> v) {
  using std::abs, std::sqrt;
  const F slope = alpha * sqrt(v.x * v.x + v.y * v.y) / abs(v.z);
  return 2.f / (1.f + sqrt(1.f + slope * slope));
}
// The normal is a point of the visible cap [Dupuy and Benyoub 2023].
template <class F>
Vec3T<F> sampleGgxNormal(F alpha, Vec3T<F> v, F u1, F u2) {
  using std::max, std::sqrt;
  const auto unit = [](const Vec3T<F>& a) { return a * F(1.f / sqrt(dot(a, a))); };
  const Vec3T<F> s = unit({alpha * v.x, alpha * v.y, max(F(1e-7f), v.z)});
  const F height = (1.f - u1) * (1.f + s.z), z = height - s.z;
  const F r = sqrt(max(F(0.f), 1.f - z * z));
  const auto [sine, cosine] = sinCosOfTurn(u2);
  return unit({alpha * (s.x + r * cosine), alpha * (s.y + r * sine), height});
}

// D: the area of microfacets of normal m, per area and solid angle [Walter 2007 (25), (33)].
inline float normalDensity(const Microfacets& f, Vec3 m) {
  if (f.kind == MicrofacetKind::kGgx) return ggxDensity(f.alpha, m);
  const float cos2 = std::max(1e-12f, m.z * m.z), inv_alpha2 = 1 / (f.alpha * f.alpha);
  const float e = (m.x * m.x + m.y * m.y) * inv_alpha2;
  return kInvPi * inv_alpha2 * std::exp(-e / cos2) / (cos2 * cos2);
}

// G1: of the microfacets that face v, the fraction that is visible from v [Walter 2007 (34)]. Beckmann's is
// in closed form [Heitz 2014]. Mitsuba has a fit with an error of 0.4 %.
inline float visibleFraction(const Microfacets& f, Vec3 v) {
  if (f.kind == MicrofacetKind::kGgx) return ggxVisible(f.alpha, v);
  const float slope = f.alpha * std::sqrt(v.x * v.x + v.y * v.y) / std::abs(v.z);
  const float a = 1 / std::max(1e-6f, slope);
  const float tail = std::exp(-a * a) * std::numbers::inv_sqrtpi_v<float> / a;
  return 2 / (2 + tail - std::erfc(a));
}

// Samples a normal that is visible from v at roughness 1. It has any length.
inline Vec3 sampleBeckmannNormal(Vec3 v, float u1, float u2) {
  const Slope s = sampleBeckmannSlope(v.z, u1, u2);
  const float sin_v = std::sqrt(v.x * v.x + v.y * v.y);
  const float cos_phi = sin_v > 0 ? v.x / sin_v : 1.f, sin_phi = sin_v > 0 ? v.y / sin_v : 0.f;
  return {sin_phi * s.y - cos_phi * s.x, -sin_phi * s.x - cos_phi * s.y, 1};
}

// Samples a unit normal with the density of visible normals, D G1 max(0, v.m) / v.z, for v.z > 0. The
// roughness becomes 1 where v is stretched, and the normal is stretched back [Heitz 2014].
inline Vec3 sampleVisibleNormal(const Microfacets& f, Vec3 v, float u1, float u2) {
  if (f.kind == MicrofacetKind::kGgx) return sampleGgxNormal(f.alpha, v, u1, u2);
  const Vec3 stretched = normalize(Vec3{f.alpha * v.x, f.alpha * v.y, std::max(1e-7f, v.z)});
  const Vec3 m = sampleBeckmannNormal(stretched, u1, u2);
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
