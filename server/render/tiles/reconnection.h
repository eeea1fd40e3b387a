// Paths of one frame go on from the vertex that their pixel shows in the other frame, to their own second
// vertex. This is the shift of gradient-domain path tracing (Kettunen et al. 2015), for pixels of two frames.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>

#include "render/paths/tracing.h"
#include "render/surface/path_start.h"
#include "render/surface/scatter.h"
#include "render/world/surface_at.h"

namespace saccade {

// Whether paths may be reconnected there: diffuse and opaque.
template <Shading S>
bool connects(const Surface& s) {
  return S.diffuseOnly() || (s.opacity >= 1 && s.bsdf.tables->model.kind == BsdfKind::kDiffuse);
}

// The second vertex of a path that begins where it connects(); none: its ray leaves the scene.
template <Shading S>
std::optional<PathStart> secondVertex(const PosedScene& scene, const PathStart& x1,
                                      const PathSampler& numbers) {
  const Scatter<kPlainDiffuse> scatter(x1.surface, x1.direction);
  const BsdfSample next = scatter.sample(0, numbers.u(kBounce), numbers.u(kBounce + 1));
  if (next.pdf <= 0) return {};
  const Ray ray{leave(x1.surface), next.wi, std::numeric_limits<float>::infinity()};
  const Hit hit = scene.geometry().intersect(ray);
  if (!hit.valid) return {};
  RayCone cone{x1.cone.width, RayCone::lobeSpread(next.pdf)};
  cone.width = cone.at(hit.t);
  return PathStart{surfaceAt<S>(scene, ray, hit, cone.width), next.wi, cone};
}

// G(x1, x2) without visibility: pi times the pdf, per area, with which paths go from x1 to x2.
inline float geometryTerm(const Surface& x1, const Surface& x2) {
  const Vec3 way = x2.point - leave(x1);
  const float distance2 = dot(way, way), cos1 = dot(way, x1.shading_normal),
              cos2 = -dot(way, x2.geometric_normal);
  if (std::min({cos1, cos2, dot(way, x1.geometric_normal)}) <= 0) return 0;
  return cos1 * cos2 / (distance2 * distance2);
}

// The same with visibility.
inline float visibleTerm(const PosedScene& scene, const Surface& x1, const Surface& x2) {
  const float G = geometryTerm(x1, x2);
  const Vec3 origin = leave(x1);
  return G > 0 && !scene.geometry().occluded({origin, leave(x2) - origin, kShadowEnd}) ? G : 0;
}

}  // namespace saccade
