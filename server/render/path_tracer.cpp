#include "render/path_tracer.h"

#include <limits>

#include "render/bsdf.h"

namespace saccade {
namespace {

// Every vertex has its own random dimensions, so that paths that part at one vertex still share the numbers
// of the next.
enum Dimension { kLight, kLightU, kLightV, kBounceU, kBounceV, kDimensions };

constexpr float kShadowEnd = 1 - 1e-4f;      // shadow rays stop just before the light
constexpr float kIndirectFootprint = 0.25f;  // per distance: a diffuse lobe is wide, so coarse mips will do

// Light from a point chosen on a light source.
template <int Channels>
Color<Channels> directLight(const RenderScene& scene, const EmitterStrengths& strengths, const Surface& s,
                            const PathSampler& sampler, int dimension) {
  const LightSample light = scene.lights().sample(
      sampler.u(dimension + kLight), sampler.u(dimension + kLightU), sampler.u(dimension + kLightV));
  const Vec3 origin = scene.leave(s), to_light = light.point - origin;
  const Lane distance2 = dot(to_light, to_light), distance = std::sqrt(distance2);
  const Vec3 w = to_light / distance;
  const Lane cos_s = dot(w, s.shading_normal), cos_light = -dot(w, light.normal);
  if (cos_s <= 0 || cos_light <= 0 || dot(w, s.geometric_normal) <= 0) return {};
  if (scene.geometry().occluded({origin, to_light, kShadowEnd})) return {};
  const Lane pdf_light = light.pdf * distance2 / cos_light;  // per solid angle
  const Lane weight = balance(pdf_light, cosinePdf(cos_s));
  return Color<Channels>(light.radiance) * (weight * cos_s * kInvPi / pdf_light * strengths[light.geometry]);
}

}  // namespace

template <int Channels>
Color<Channels> traceReflected(const RenderScene& scene, const EmitterStrengths& strengths,
                               const Surface& primary, const PathSampler& sampler, int bounces) {
  Color<Channels> radiance, throughput(Lane(1));
  if (scene.lights().empty()) return radiance;
  Surface s = primary;
  for (int vertex = 0;; ++vertex) {
    throughput = throughput * Color<Channels>(s.albedo);
    if (throughput.luminance() <= 0) return radiance;
    const int dimension = vertex * kDimensions;
    radiance += throughput * directLight<Channels>(scene, strengths, s, sampler, dimension);

    // Continue in a direction of the BSDF.
    const DirectionSample next =
        sampleCosine(s.shading_normal, sampler.u(dimension + kBounceU), sampler.u(dimension + kBounceV));
    if (next.pdf <= 0 || dot(next.direction, s.geometric_normal) <= 0) return radiance;
    const Ray ray{scene.leave(s), next.direction, std::numeric_limits<float>::infinity()};
    const Hit hit = scene.geometry().intersect(ray);
    if (!hit.valid) return radiance;
    s = scene.surface(ray, hit, kIndirectFootprint * hit.t);

    // Light found by chance: direct light of the vertex we come from.
    if (luminance(s.radiance) > 0) {
      const Lane cos_light = -dot(next.direction, s.geometric_normal);
      const Lane pdf_light = scene.lights().pdf(s.radiance) * hit.t * hit.t / std::max(cos_light, 1e-6f);
      radiance +=
          throughput * Color<Channels>(s.radiance) * (balance(next.pdf, pdf_light) * strengths[hit.geometry]);
    }
    if (vertex == bounces) return radiance;
  }
}

template Color<1> traceReflected<1>(const RenderScene&, const EmitterStrengths&, const Surface&,
                                    const PathSampler&, int);
template Color<3> traceReflected<3>(const RenderScene&, const EmitterStrengths&, const Surface&,
                                    const PathSampler&, int);

}  // namespace saccade
