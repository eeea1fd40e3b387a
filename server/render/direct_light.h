// Direct light: light that comes straight from a light source.
#pragma once

#include "render/bsdf/sampling.h"
#include "render/color.h"
#include "render/path_sampler.h"
#include "render/scatter.h"
#include "render/surface_at.h"
#include "scene/emitter_strengths.h"

namespace saccade {

// Balance heuristic (Veach 1995).
inline float balance(float pdf, float other) {
  return pdf / (pdf + other);
}

// The light that panes and masks let through along a shadow ray.
template <Shading S>
Transmittance transmittanceAlong(const RenderScene& scene, Ray ray, Vec3 direction) {
  constexpr int kMaxTransmissions = 16;
  Transmittance all;
  for (int i = 0; i < kMaxTransmissions; ++i) {
    const Hit hit = scene.geometry().intersect(ray);
    if (!hit.valid) return all;
    const Surface s = surfaceAt<S>(scene, ray, hit, RayCone::kDiffuseSpread * hit.t);
    const Transmittance one = Scatter<S>(s, direction).straightTransmittance();
    all = {all.fraction * one.fraction, all.probability * one.probability};
    if (luminance(all.fraction) <= 0) break;
    ray.origin = scene.leave(s, true);
    ray.tfar -= hit.t;
  }
  return {{}, 0};
}

// One estimate of the direct light, by a sample of the lights. Its weight is the share of this sample in the
// balance heuristic. `dimension` is the first of three random numbers.
// Inlining is forced, because a call costs 5 % of a frame.
template <Shading S, int Channels, class Parts>
[[gnu::always_inline]] inline Color<Channels> directLight(const RenderScene& scene,
                                                          const EmitterStrengths& strengths, const Surface& s,
                                                          const Scatter<S>& scatter,
                                                          const PathSampler& sampler, int dimension,
                                                          Parts& parts) {
  const Vec3 origin = scene.leave(s);
  const IncidentLight light =
      scene.lights().at(origin, sampler.u(dimension), sampler.u(dimension + 1), sampler.u(dimension + 2));
  if (light.pdf <= 0) return {};
  BsdfValue f = scatter.evaluate(light.direction);
  if (f.pdf <= 0) return {};
  if constexpr (Parts::kKept) {
    const float strength = light.geometry == IncidentLight::kNoGeometry ? 1 : strengths[light.geometry];
    const float white = cosinePdf(std::max(0.f, dot(light.direction, s.shading_normal)));
    if (scene.analyticLight().holds(light))
      parts.unoccluded = Color<Channels>(light.radiance) * (white * strength / light.pdf);
  }
  const Ray shadow{origin, light.segment, light.reach};
  if (S.extras && scene.hasStraightTransmission()) {
    const Transmittance through = transmittanceAlong<S>(scene, shadow, light.direction);
    if (through.probability <= 0) return {};
    f = {f.value * through.fraction, f.pdf * through.probability};
    if constexpr (Parts::kKept) parts.visible = parts.unoccluded * Color<Channels>(through.fraction);
  } else if (scene.geometry().occluded(shadow)) {
    return {};
  } else if constexpr (Parts::kKept) {
    parts.visible = parts.unoccluded;
  }
  float weight = light.delta ? 1 : balance(light.pdf, f.pdf);
  if (light.geometry != IncidentLight::kNoGeometry) weight *= strengths[light.geometry];
  const Color<Channels> found =
      Color<Channels>(light.radiance) * Color<Channels>(f.value) * (weight / light.pdf);
  if constexpr (Parts::kKept)
    if (scene.analyticLight().holds(light)) parts.weighed = found;
  return found;
}

}  // namespace saccade
