#include "render/gbuffer_pass.h"

#include <cmath>
#include <limits>

namespace saccade {
namespace {

// max(|dz/dx|, |dz/dy|) of the plane through `offset` (from the camera) with normal n, at depth z.
float planeSlope(const Camera& camera, Vec3 direction, Vec3 offset, Vec3 n, float z) {
  const float height = dot(offset, n);
  const auto step = [&](Vec3 axis) {
    const float towards = dot(direction + axis * camera.pixel, n);
    return std::abs(height / towards - z);
  };
  const float dz = std::max(step(camera.right), step(camera.down));
  return dz < z ? dz : z;  // also where the next ray runs along the plane
}

void setMotion(const Camera::Projection& now, const Camera::Projection& before, int x, int y, GBuffer& g) {
  // Both projections by the same formula: a standing camera gives exactly 0.
  const bool seen = before.z > 0;
  g.motion_x.at(x, y) = seen ? before.x - now.x : 1e6f;  // behind the previous camera: far outside
  g.motion_y.at(x, y) = seen ? before.y - now.y : 1e6f;
  g.z_in_prev.at(x, y) = before.z;
}

}  // namespace

PrimaryHit tracePrimary(const RenderScene& scene, const EmitterStrengths& strengths, const Camera& camera,
                        const Camera& prev, int x, int y, GBuffer& g) {
  const Vec3 direction = camera.direction(static_cast<float>(x), static_cast<float>(y));
  const Ray ray{camera.origin, direction, std::numeric_limits<float>::infinity()};
  const Hit hit = scene.geometry().intersect(ray);
  if (!hit.valid) {
    for (ImageF* plane : {&g.dz, &g.nx, &g.ny, &g.albedo, &g.emission}) plane->at(x, y) = 0;
    g.nz.at(x, y) = 1;
    setMotion(camera.projectDirection(direction), prev.projectDirection(direction), x, y, g);
    g.z.at(x, y) = g.z_in_prev.at(x, y) = kMissDepth;
    return {};
  }
  const Surface s = scene.surface(ray, hit, hit.t * camera.pixel);
  const PrimaryHit primary{s, s.radiance * strengths[hit.geometry], true};
  g.z.at(x, y) = hit.t;
  g.dz.at(x, y) = planeSlope(camera, direction, s.point - camera.origin, s.geometric_normal, hit.t);
  g.nx.at(x, y) = s.shading_normal.x;
  g.ny.at(x, y) = s.shading_normal.y;
  g.nz.at(x, y) = s.shading_normal.z;
  g.albedo.at(x, y) = luminance(s.albedo);
  g.emission.at(x, y) = luminance(primary.emission);
  setMotion(camera.project(s.point), prev.project(s.point), x, y, g);
  return primary;
}

}  // namespace saccade
