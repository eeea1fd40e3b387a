#include "render/path_tracer.h"

#include <limits>

#include "render/scatter.h"
#include "render/surface_at.h"

namespace saccade {
namespace {

// Every vertex has its own random dimensions, so that paths that part at one vertex still share the numbers
// of the next.
enum Dimension { kLight, kLightU, kLightV, kBounceU, kBounceV, kLobe, kDimensions };

constexpr int kMaxDeltas = 16;  // mirrors and glass that a path may meet besides its bounces

// Balance heuristic (Veach 1995).
Lane balance(Lane pdf, Lane other) {
  return pdf / (pdf + other);
}

// Light from a point chosen on a light source.
template <Shading S, int Channels>
Color<Channels> directLight(const RenderScene& scene, const EmitterStrengths& strengths, const Surface& s,
                            const Scatter<S>& scatter, const PathSampler& sampler, int dimension) {
  const Vec3 origin = scene.leave(s);
  const IncidentLight light = scene.lights().at<S>(
      origin, sampler.u(dimension + kLight), sampler.u(dimension + kLightU), sampler.u(dimension + kLightV));
  if (light.pdf <= 0) return {};
  const BsdfValue f = scatter.evaluate(light.direction);
  if (f.pdf <= 0 || scene.geometry().occluded({origin, light.segment, light.reach})) return {};
  Lane weight = light.delta ? 1 : balance(light.pdf, f.pdf);
  if (light.geometry != IncidentLight::kNoGeometry) weight *= strengths[light.geometry];
  return Color<Channels>(light.radiance) * Color<Channels>(f.value) * (weight / light.pdf);
}

}  // namespace

template <Shading S, int Channels>
Color<Channels> traceReflected(const RenderScene& scene, const EmitterStrengths& strengths,
                               const PathStart& start, const PathSampler& sampler, int bounces) {
  Color<Channels> radiance, throughput(Lane(1));
  const Lights& lights = scene.lights();
  if (lights.empty()) return radiance;
  Surface s = start.surface;
  Vec3 arriving = start.direction;
  RayCone cone = start.cone;
  bool in_view = S == Shading::kAll;
  for (int vertex = 0, bounce = 0; vertex <= bounces + kMaxDeltas; ++vertex) {
    const int dimension = vertex * kDimensions;
    const Scatter<S> scatter(s, arriving);
    radiance += throughput * directLight<S, Channels>(scene, strengths, s, scatter, sampler, dimension);

    // Continue in a direction of the BSDF.
    const BsdfSample next = scatter.sample(sampler.u(dimension + kLobe), sampler.u(dimension + kBounceU),
                                           sampler.u(dimension + kBounceV));
    if (next.pdf <= 0) return radiance;
    throughput = throughput * Color<Channels>(next.weight);
    if (throughput.luminance() <= 0) return radiance;
    if constexpr (S == Shading::kAll) in_view = in_view && vertex < kMaxViewDepth && scatter.isView(next);
    if (!next.delta) cone.spread = RayCone::lobeSpread(next.pdf);
    const Ray ray{scene.leave(s, next.transmitted), next.wi, std::numeric_limits<float>::infinity()};
    const Hit hit = scene.geometry().intersect(ray);
    if (!hit.valid) {
      if constexpr (S == Shading::kAll) {
        const Lane weight = next.delta ? 1 : balance(next.pdf, lights.distantPdf(next.wi));
        if (!in_view) radiance += throughput * Color<Channels>(lights.distantRadiance(next.wi)) * weight;
      }
      return radiance;
    }
    cone.width = cone.at(hit.t);
    s = surfaceAt<S>(scene, ray, hit, cone.width);
    arriving = next.wi;

    // Light found by chance: direct light of the vertex we come from.
    if (luminance(s.radiance) > 0 && !in_view) {
      const Lane cos_light = -dot(next.wi, s.geometric_normal);
      const Lane pdf_light = lights.pdf(s.radiance) * hit.t * hit.t / std::max(cos_light, 1e-6f);
      const Lane weight = next.delta ? 1 : balance(next.pdf, pdf_light);
      radiance += throughput * Color<Channels>(s.radiance) * (weight * strengths[hit.geometry]);
    }
    if (!next.delta && bounce++ == bounces) return radiance;
  }
  return radiance;
}

template Color<1> traceReflected<Shading::kDiffuse, 1>(const RenderScene&, const EmitterStrengths&,
                                                       const PathStart&, const PathSampler&, int);
template Color<3> traceReflected<Shading::kDiffuse, 3>(const RenderScene&, const EmitterStrengths&,
                                                       const PathStart&, const PathSampler&, int);
template Color<1> traceReflected<Shading::kTexturedDiffuse, 1>(const RenderScene&, const EmitterStrengths&,
                                                               const PathStart&, const PathSampler&, int);
template Color<3> traceReflected<Shading::kTexturedDiffuse, 3>(const RenderScene&, const EmitterStrengths&,
                                                               const PathStart&, const PathSampler&, int);
template Color<1> traceReflected<Shading::kAll, 1>(const RenderScene&, const EmitterStrengths&,
                                                   const PathStart&, const PathSampler&, int);
template Color<3> traceReflected<Shading::kAll, 3>(const RenderScene&, const EmitterStrengths&,
                                                   const PathStart&, const PathSampler&, int);

}  // namespace saccade
