#include "render/primary/gbuffer_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "render/camera/pixel_features.h"
#include "render/world/coherent_rays.h"
#include "render/world/surface_at.h"

namespace saccade {
namespace {

void setMotion(const Camera::Projection& now, const Camera::Projection& before, int x, int y, GBuffer& g) {
  const auto [motion_x, motion_y] = motionBetween(now, before);
  g.motion_x.at(x, y) = motion_x, g.motion_y.at(x, y) = motion_y;
  g.z_in_prev.at(x, y) = before.z;
}

// `now` and `before`: from the cameras to the point, or the direction of a point at infinity.
void projectMotion(const Camera& camera, const Camera& prev, Vec3 now, Vec3 before, int x, int y,
                   GBuffer& g) {
  if (!camera.isPlain())
    return setMotion(camera.projectDirection(now), prev.projectDirection(before), x, y, g);
  setMotion(camera.projectPlain(now), prev.projectPlain(before), x, y, g);
}

void setNormal(Vec3 n, int x, int y, GBuffer& g) {
  g.nx.at(x, y) = n.x, g.ny.at(x, y) = n.y, g.nz.at(x, y) = n.z;
}

// A ray that hits nothing counts as a hit on one far surface.
void setFar(const Camera& camera, const Camera& prev, Vec3 direction, int x, int y, GBuffer& g) {
  setNormal({0, 0, 1}, x, y, g);
  projectMotion(camera, prev, direction, direction, x, y, g);
  g.z.at(x, y) = g.z_in_prev.at(x, y) = kMissDepth;
  g.dz.at(x, y) = 0;
}

}  // namespace

// Shades the hit of a ray, whose origin is `before` lengths of its direction away from the camera. Makes the
// parts of `out` where they lie: a copy would wait for each of its values to reach the cache. `apart`: a mask
// is taken for opaque. Returns its opacity.
template <Shading S>
float shadeRay(const PixelContext& view, const Ray& ray, float before, const Hit& hit, bool apart,
               PrimaryHit& out) {
  out.direction = ray.direction;
  out.valid = hit.valid;
  const Vec3 unit = normalize(ray.direction);
  if (!hit.valid) {
    out.start = {}, out.guide = {};
    out.guide.hit = false;
    if constexpr (S.extras) out.guide.emission = view.now.scene.lights().distant().radiance(unit);
    return 1;
  }
  RayCone cone{0, view.now.camera.pixelAt(ray.direction)};
  cone.width = cone.at(before + hit.t);
  new (&out.start) PathStart{surfaceAt<S>(view.now.scene, ray, hit, cone.width), unit, cone};
  const float opacity = out.start.surface.opacity;
  if (apart) out.start.surface.opacity = 1;
  new (&out.guide) Guide(findGuide<S>(view, ray, hit, out.start));
  out.guide.t += before;
  // Masks do not thin what they emit.
  if (apart && opacity > 0) out.guide.emission = out.guide.emission * (1 / opacity);
  return opacity;
}

template <Shading S>
void shadePrimary(const PixelContext& view, const Ray& ray, const Hit& hit, PrimaryHit& out) {
  shadeRay<S>(view, ray, 0, hit, false, out);
}

namespace {

// As many rays as there are hits.
void tracePoints(const PixelContext& view, std::span<const Vec2> points, std::span<Ray> rays,
                 std::span<Hit> found) {
  for (std::size_t i = 0; i < points.size(); ++i)
    rays[i] = {view.now.camera.origin, view.now.camera.direction(points[i].x, points[i].y),
               std::numeric_limits<float>::infinity()};
  intersectCoherent(view.now.scene.geometry(), rays, found);
}

// The layers of one ray. Returns how many there are.
template <Shading S>
std::size_t shadeLayers(const PixelContext& view, Ray ray, Hit hit, std::span<Layer> layers) {
  float left = 1, before = 0;
  std::size_t count = 0;
  for (int masks = 0;; ++masks) {
    Layer& layer = layers[count];
    const bool last = count + 1 == layers.size() || masks == kMaxViewDepth;
    const float opacity = shadeRay<S>(view, ray, before, hit, !last, layer.hit);
    layer.share = last ? left : left * opacity;
    if (layer.share > 0) ++count;
    left -= layer.share;
    if (left <= 0) return count;
    before += hit.t;
    ray.origin = leave(layer.hit.start.surface, true);
    hit = view.now.scene.geometry().intersect(ray);
  }
}

}  // namespace

template <Shading S>
void tracePrimaries(const PixelContext& view, std::span<const Vec2> points, std::span<PrimaryHit> hits) {
  std::array<Ray, kMostPoints> rays;
  std::array<Hit, kMostPoints> found;
  tracePoints(view, points, rays, std::span(found).first(points.size()));
  for (std::size_t i = 0; i < hits.size(); ++i) shadePrimary<S>(view, rays[i], found[i], hits[i]);
}

template <Shading S>
std::size_t traceLayers(const PixelContext& view, std::span<const Vec2> points, std::span<Layer> layers) {
  std::array<Ray, kMostPoints> rays;
  std::array<Hit, kMostPoints> found;
  tracePoints(view, points, rays, std::span(found).first(points.size()));
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t room = layers.size() - count - (points.size() - i - 1);
    const std::size_t first = count;
    count += shadeLayers<S>(view, rays[i], found[i], layers.subspan(first, std::min(room, kMostLayers)));
    for (Layer& layer : layers.subspan(first, count - first)) layer.point = i;
  }
  return count;
}

void writeFeatures(const PrimaryHit& primary, const Camera& camera, const Camera& prev, int x, int y,
                   GBuffer& g) {
  const Guide& guide = primary.guide;
  if (g.hasBodies()) g.body.at(x, y) = guide.hit ? guide.on.body + 1 : 0;
  g.albedo.at(x, y) = luminance(guide.albedo);
  g.emission.at(x, y) = luminance(guide.emission);
  if (!guide.hit) return setFar(camera, prev, primary.direction, x, y, g);
  setNormal(guide.normal, x, y, g);
  projectMotion(camera, prev, guide.point - camera.origin, guide.point_before - prev.origin, x, y, g);
  g.z.at(x, y) = guide.t;
  g.dz.at(x, y) = planeSlope(camera.nextRight(primary.direction), camera.nextDown(primary.direction),
                             guide.point - camera.origin, guide.plane_normal, guide.t);
}

#define INSTANTIATE(S)                                                                                \
  template void shadePrimary<S>(const PixelContext&, const Ray&, const Hit&, PrimaryHit&);            \
  template void tracePrimaries<S>(const PixelContext&, std::span<const Vec2>, std::span<PrimaryHit>); \
  template std::size_t traceLayers<S>(const PixelContext&, std::span<const Vec2>, std::span<Layer>);
INSTANTIATE(kPlainDiffuse)
INSTANTIATE(kTexturedDiffuse)
INSTANTIATE(kPlastics)
INSTANTIATE(kEverything)

}  // namespace saccade
