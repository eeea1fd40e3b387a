// Follows the view to the surface that guides the filter. For kernel.h.
#pragma once

#include "render/primary/guide.h"

#include <array>
#include <limits>

#include "render/surface/scatter.h"
#include "render/world/surface_at.h"

namespace saccade {
namespace detail {

inline constexpr float kView = 0.5f;  // Scatter::isView()

inline Vec3 mirrored(Vec3 v, Vec3 about) {
  return v - about * (2 * dot(v, about));
}

// Follows the view from `start` through mirrors, clear glass and masks. It ends at any other surface.
template <Shading S>
Guide followView(const PixelContext& view, const Ray& primary, const Hit& first, const PathStart& start) {
  const PosedScene& scene = view.now.scene;
  Guide g{};
  Rgb throughput{1, 1, 1};
  float distance = 0;  // beyond `start`
  std::array<Vec3, kMaxViewDepth> mirrors;
  std::size_t mirror_count = 0;
  Surface s = start.surface;
  Vec3 direction = start.direction;
  RayCone cone = start.cone;
  ShapePoint on = first;
  for (int depth = 0;; ++depth) {
    g.emission = g.emission + throughput * s.radiance * scene.strengths()[on.geometry];
    const Scatter<S> scatter(s, direction);
    const BsdfSample next = scatter.sample(kView, kView, kView);
    if (depth == kMaxViewDepth || !scatter.isView(next)) {
      g.albedo = g.albedo + throughput * scatter.albedo();
      break;
    }
    g.albedo = g.albedo + throughput * (1 - next.pdf);  // of the light that leaves the view here
    throughput = throughput * next.weight * next.pdf;
    if (!next.transmitted) mirrors[mirror_count++] = scatter.normal();
    const Ray ray{leave(s, next.transmitted), next.wi, std::numeric_limits<float>::infinity()};
    const Hit hit = scene.geometry().intersect(ray);
    if (!hit.valid) {
      g.emission = g.emission + throughput * scene.lights().distant().radiance(next.wi);
      g.hit = false;
      return g;
    }
    distance += hit.t;
    cone.width = cone.at(hit.t);
    s = surfaceAt<S>(scene, ray, hit, cone.width);
    direction = next.wi, on = hit;
  }
  g.has_base = bsdfHasBase<S.kinds>(s.bsdf);
  g.normal = s.shading_normal;
  g.plane_normal = s.geometric_normal;
  Vec3 step = view.pointBefore(on, s.point) - s.point;
  while (mirror_count > 0) {
    const Vec3 about = mirrors[--mirror_count];
    g.plane_normal = mirrored(g.plane_normal, about), step = mirrored(step, about);
  }
  g.t = first.t + distance / length(primary.direction);
  g.point = distance > 0 ? primary.origin + primary.direction * g.t : s.point;
  g.point_before = g.point + step;
  g.on = on;
  return g;
}

// The emission that a ray shows, and what it sees in mirrors, clear glass and masks. `cone`: at its origin.
template <Shading S>
Rgb emissionAlong(const PosedScene& scene, Ray ray, RayCone cone) {
  Rgb light, throughput{1, 1, 1};
  for (int depth = 1;; ++depth) {
    const Hit hit = scene.geometry().intersect(ray);
    if (!hit.valid) return light + throughput * scene.lights().distant().radiance(ray.direction);
    cone.width = cone.at(hit.t);
    const Surface s = surfaceAt<S>(scene, ray, hit, cone.width);
    light = light + throughput * s.radiance * scene.strengths()[hit.geometry];
    const Scatter<S> scatter(s, ray.direction);
    const BsdfSample next = scatter.sample(kView, kView, kView);
    if (depth == kMaxViewDepth || !scatter.isView(next)) return light;
    throughput = throughput * next.weight * next.pdf;
    ray.origin = leave(s, next.transmitted), ray.direction = next.wi;
  }
}

}  // namespace detail

template <Shading S>
Rgb mirrorImage(const PosedScene& scene, const PathStart& start) {
  // Surfaces of these kinds mirror light beside another lobe.
  constexpr BsdfKinds kMirrors = only(BsdfKind::kPlastic) | only(BsdfKind::kDielectric) |
                                 only(BsdfKind::kThinDielectric) | only(BsdfKind::kCoatedConductor);
  if constexpr ((S.kinds & kMirrors) != 0) {
    const Surface& s = start.surface;
    if ((kMirrors & only(s.bsdf.tables->model.kind)) == 0) return {};
    const Scatter<S> scatter(s, start.direction);
    const BsdfSample image = scatter.sample(0, 0, 0);
    if (!scatter.isImage(image)) return {};
    const Ray ray{leave(s), image.wi, std::numeric_limits<float>::infinity()};
    return image.weight * image.pdf * detail::emissionAlong<S>(scene, ray, start.cone);
  }
  return {};
}

template <Shading S>
Guide findGuide(const PixelContext& view, const Ray& ray, const Hit& hit, const PathStart& start) {
  if constexpr (S.extras) return detail::followView<S>(view, ray, hit, start);
  const Surface& s = start.surface;
  return {s.point,
          view.pointBefore(hit, s.point),
          s.shading_normal,
          s.geometric_normal,
          hit.t,
          Scatter<S>(s, start.direction).albedo(),
          s.radiance * view.now.scene.strengths()[hit.geometry],
          hit,
          true,
          true};
}

}  // namespace saccade
