#include "feed/shadow_motion.h"

#include <cmath>
#include <limits>

#include "render/world/ray_offset.h"

namespace saccade {
namespace {

constexpr std::size_t kMostLamps = 4;
constexpr float kNone = std::numeric_limits<float>::infinity();

Vec3 normalAt(const BodyPoint& point, Vec3 rest_normal, std::span<const RigidMotion> motions) {
  return point.body > 0 ? motions[point.body - 1].direction(rest_normal) : rest_normal;
}

}  // namespace

ShadowMotion::ShadowMotion(const Scene& scene, int width, int height, std::size_t most_points)
    : width_(static_cast<float>(width)),
      height_(static_cast<float>(height)),
      lamps_(strongestLamps(scene, kMostLamps)) {
  shadows_.reserve(most_points * lamps_.size());
}

void ShadowMotion::look(std::span<const ViewedPoint> points, const PosedScene& scene) {
  shadows_.clear();
  for (const LampPlace& lamp : lamps_)
    for (const ViewedPoint& point : points) lookAt(point, lamp, scene);
}

void ShadowMotion::lookAt(const ViewedPoint& point, const LampPlace& lamp, const PosedScene& scene) {
  const auto motions = scene.bodies()->motions();
  const Vec3 on = point.point.at(motions), n = normalAt(point.point, point.rest_normal, motions);
  const Vec3 to_lamp = lamp.middle.at(motions) - on;
  const float distance = length(to_lamp);
  if (!(dot(n, to_lamp) > 0) || distance <= lamp.radius) return;
  const Vec3 origin = on + n * rayOffset(on, on, distance);
  const Hit hit = scene.geometry().intersect({origin, to_lamp, 1 - lamp.radius / distance});
  if (!hit.valid) return;
  const std::uint32_t caster = hit.body == kNoBody ? 0 : hit.body + 1;
  if (caster == lamp.middle.body && caster == point.point.body) return;  // they move as one, or stand
  shadows_.push_back({point.point, point.rest_normal,
                      BodyPoint::of(origin + to_lamp * hit.t, caster, motions), lamp.middle, point.at});
}

Vec3 ShadowMotion::placeOf(const Shadow& shadow, std::span<const RigidMotion> motions) {
  const Vec3 on = shadow.lit.at(motions), lamp = shadow.lamp.at(motions);
  const Vec3 n = normalAt(shadow.lit, shadow.rest_normal, motions);
  const Vec3 ray = shadow.caster.at(motions) - lamp;
  const float t = dot(n, on - lamp) / dot(n, ray);
  return t > 0 ? lamp + ray * t : Vec3{kNone, kNone, kNone};
}

void ShadowMotion::appendSteps(const Camera& camera, std::span<const RigidMotion> motions,
                               std::vector<float>& lengths) {
  for (Shadow& shadow : shadows_) {
    const Camera::Projection before = shadow.at;
    shadow.at = camera.project(placeOf(shadow, motions));
    const float px = std::hypot(shadow.at.x - before.x, shadow.at.y - before.y);
    if (shows(before) && shadow.at.z > 0 && std::isfinite(px)) lengths.push_back(px);
  }
}

bool ShadowMotion::shows(const Camera::Projection& at) const {
  return at.z > 0 && at.x > -1 && at.x < width_ && at.y > -1 && at.y < height_;
}

}  // namespace saccade
