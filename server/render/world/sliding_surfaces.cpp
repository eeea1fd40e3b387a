#include "render/world/sliding_surfaces.h"

#include <cmath>

namespace saccade {
namespace {

constexpr float kMostTurn = 1e-4f;    // of the normal: what rounding turns it
constexpr float kMostAscent = 0.05f;  // of a step that slides, along the normal
constexpr float kDepth = 0.5f;        // of the offset of rays: so far off a point the surface may be
constexpr float kLeastStep = 1e-4f;   // of a body's size: rounding turns smaller ones

bool isStep(const Body& body, const RigidMotion& from, const RigidMotion& to) {
  const float least = kLeastStep * length(body.high - body.low);
  for (const Vec3 corner : {body.low, body.high, Vec3{body.low.x, body.high.y, body.high.z}})
    if (length(to.point(corner) - from.point(corner)) > least) return true;
  return false;
}

}  // namespace

void SlidingSurfaces::next(const PosedScene& now, const PosedScene& before) {
  if (!now.bodies()) return;
  scene_ = &now.still();
  const auto to = now.bodies()->motions(), from = before.bodies()->motions();
  last_.resize(to.size());
  for (std::size_t i = 0; i < to.size(); ++i)
    if (!now.bodies()->deforms(i) && isStep(scene_->description().bodies[i], from[i], to[i]))
      last_[i] = {from[i], to[i], true};
}

bool SlidingSurfaces::at(std::uint32_t body, const SeenPoint& point) const {
  const Step& step = last_[body];
  if (!step.any) return false;
  // Where the body shows now what it showed here before the step.
  const Vec3 rest = step.from.restPoint(point.position), normal = step.from.restDirection(point.normal);
  const Vec3 way = step.to.point(rest) - point.position;
  if (std::abs(dot(way, point.normal)) > kMostAscent * length(way)) return false;
  if (shows(body, rest, normal, point.offset)) return true;
  // Another such step.
  const Vec3 after = step.to.restPoint(step.from.point(step.to.restPoint(point.position)));
  const Vec3 normal_after = step.to.restDirection(step.from.direction(step.to.restDirection(point.normal)));
  return shows(body, after, normal_after, point.offset);
}

bool SlidingSurfaces::shows(std::uint32_t body, Vec3 rest, Vec3 rest_normal, float offset) const {
  const float depth = kDepth * offset;
  const Hit hit =
      scene_->bodies()[body]->all.intersect({rest + rest_normal * depth, -rest_normal, 2 * depth});
  if (!hit.valid) return false;
  const Vec3 n = normalize(hit.normal);
  return length(dot(n, rest_normal) < 0 ? n + rest_normal : n - rest_normal) <= kMostTurn;
}

}  // namespace saccade
