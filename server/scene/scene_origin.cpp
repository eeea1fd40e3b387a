#include "scene/scene_origin.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace saccade {
namespace {

constexpr double kFar = 128;  // diagonals

class Bounds {
 public:
  void add(Vec3d p, double radius = 0) {
    low_ = {std::min(low_.x, p.x - radius), std::min(low_.y, p.y - radius), std::min(low_.z, p.z - radius)};
    high_ = {std::max(high_.x, p.x + radius), std::max(high_.y, p.y + radius),
             std::max(high_.z, p.z + radius)};
  }
  Vec3d centre() const { return (low_ + high_) * 0.5; }
  double diagonal() const { return length(high_ - low_); }  // infinite or NaN of nothing

 private:
  static constexpr double kNone = std::numeric_limits<double>::infinity();
  Vec3d low_{kNone, kNone, kNone}, high_{-kNone, -kNone, -kNone};
};

Bounds boundsOf(const Scene& scene) {
  Bounds bounds;
  for (const Mesh& mesh : scene.meshes)
    for (std::size_t i = 0; i + 1 < mesh.positions.size(); ++i) bounds.add(toDouble(mesh.positions[i]));
  for (const Sphere& sphere : scene.spheres) bounds.add(toDouble(sphere.center), sphere.radius);
  for (const PointLight& light : scene.point_lights) bounds.add(toDouble(light.position));
  for (const SpotLight& light : scene.spot_lights) bounds.add(toDouble(light.position));
  return bounds;
}

}  // namespace

Vec3d originOf(const Scene& scene) {
  const Bounds bounds = boundsOf(scene);
  const double diagonal = bounds.diagonal();
  if (!(diagonal > 0) || !std::isfinite(diagonal)) return {};
  const double step = std::exp2(std::ceil(std::log2(diagonal)));
  const auto along = [&](double centre) {
    return std::abs(centre) > kFar * diagonal ? std::round(centre / step) * step : 0;
  };
  const Vec3d centre = bounds.centre();
  return {along(centre.x), along(centre.y), along(centre.z)};
}

}  // namespace saccade
