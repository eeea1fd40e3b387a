// The path tracer. For kernel.h.
#pragma once

#include "render/path_tracer.h"

#include <limits>

#include "render/direct_light.h"

namespace saccade {
namespace detail {

// Every vertex has its own random dimensions. So two paths that part at one vertex share the numbers of the
// next.
enum Dimension { kLight, kBounce = kLight + 3, kLobe = kBounce + 2, kDimensions };
inline constexpr int kGoOn = 1 << 16;  // of the choice to go on from light that is known

inline constexpr int kMaxDeltas = 16;  // reflections and refractions that do not count as bounces

// How the last direction that was not straight on was chosen. It decides the weight of emitters that the path
// hits.
struct Choice {
  float pdf;       // per solid angle, times the probabilities of going straight since then
  bool delta;      // samples of the lights cannot find this light
  float distance;  // since then

  float weight(float pdf_light) const { return delta ? 1 : balance(pdf, pdf_light); }
};

}  // namespace detail

template <Shading S, int Channels, class Parts>
Color<Channels> traceReflected(const RenderScene& scene, const EmitterStrengths& strengths,
                               const PathStart& start, const PathSampler& sampler, int bounces,
                               Parts& parts) {
  Color<Channels> radiance, throughput(1.f);
  const Lights& lights = scene.lights();
  if (lights.empty()) return parts.tail.end(radiance);
  Surface s = start.surface;
  Vec3 arriving = start.direction;
  RayCone cone = start.cone;
  detail::Choice choice{1, true, 0};
  const bool transmission = S.extras && scene.hasStraightTransmission();
  bool in_view = S.extras;
  bool from_start = true;  // whether the first vertex chose the direction of the ray
  NoParts none;
  for (int vertex = 0, bounce = 0; vertex <= bounces + detail::kMaxDeltas; ++vertex) {
    const int dimension = vertex * detail::kDimensions;
    const Scatter<S> scatter(s, arriving);
    const bool spent = transmission && bounce > bounces;
    if constexpr (Parts::kKept) {
      if (vertex == 0)
        radiance += directLight<S, Channels>(scene, strengths, s, scatter, sampler, detail::kLight, parts);
    }
    if (!spent && !(Parts::kKept && vertex == 0))
      radiance += throughput * directLight<S, Channels>(scene, strengths, s, scatter, sampler,
                                                        dimension + detail::kLight, none);

    // Continue in a direction that the BSDF samples.
    const BsdfSample next =
        scatter.sample(sampler.u(dimension + detail::kLobe), sampler.u(dimension + detail::kBounce),
                       sampler.u(dimension + detail::kBounce + 1));
    throughput = throughput * Color<Channels>(next.weight);
    if (next.pdf <= 0 || throughput.luminance() <= 0) return parts.tail.end(radiance);
    const bool straight = S.extras && scatter.isStraight(next);
    if (spent && !straight) return parts.tail.end(radiance);
    if (straight)
      choice.pdf *= scatter.straightTransmittance().probability;
    else
      choice = {next.pdf, next.delta, 0}, from_start = vertex == 0;
    if constexpr (S.extras) in_view = in_view && vertex < kMaxViewDepth && scatter.isView(next);
    if (!next.delta) cone.spread = RayCone::lobeSpread(next.pdf);
    const Ray ray{scene.leave(s, next.transmitted), next.wi, std::numeric_limits<float>::infinity()};
    bounce += !next.delta;
    // Where surfaces let light straight through, the last ray goes on, because shadow rays do. Else it can
    // only find light.
    const bool last = bounce > bounces && !transmission;
    if (last && !scene.mayFindLight(ray)) return parts.tail.end(radiance);
    const Hit hit = scene.geometry().intersect(ray);

    // The path has hit an emitter. That is direct light of the vertex before.
    if (!hit.valid) {
      if constexpr (S.extras)
        if (!in_view)
          radiance += throughput * Color<Channels>(lights.distantRadiance(next.wi)) *
                      choice.weight(lights.distantPdf(next.wi));
      return parts.tail.end(radiance);
    }
    cone.width = cone.at(hit.t);
    s = surfaceAt<S>(scene, ray, hit, cone.width);
    arriving = next.wi;
    choice.distance += hit.t;
    if (luminance(s.radiance) > 0 && !in_view) {
      const float cos_light = std::max(-dot(next.wi, s.geometric_normal), 1e-6f);
      const float pdf_light = lights.pdf(s.radiance) * choice.distance * choice.distance / cos_light;
      const Color<Channels> found =
          throughput * Color<Channels>(s.radiance) * (choice.weight(pdf_light) * strengths[hit.geometry]);
      radiance += found;
      if constexpr (Parts::kKept)
        if (from_start && scene.analyticLight().holds(hit.geometry)) parts.weighed += found;
    }
    if (last) return parts.tail.end(radiance);
    if constexpr (Parts::kKept) {
      if (vertex > 0 || next.delta) continue;
      const auto known = parts.tail.template begin<S>(s, arriving, cone.width, sampler.u(detail::kGoOn),
                                                      radiance, throughput);
      if (known) return radiance += throughput * *known;
    }
  }
  return parts.tail.end(radiance);
}

}  // namespace saccade
