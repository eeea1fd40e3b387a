#include "render/world/moved_bodies.h"

namespace saccade {
namespace {

constexpr std::size_t kMostTested = 8;  // boxes that each ray is tested against

void addMoved(const Body& body, const RigidMotion& motion, ShapeBox& box) {
  for (int i = 0; i < 8; ++i)
    box.add(motion.point({i & 1 ? body.high.x : body.low.x, i & 2 ? body.high.y : body.low.y,
                          i & 4 ? body.high.z : body.low.z}));
}

// With room for what Embree rounds.
ShapeBox widened(ShapeBox box) {
  constexpr float kOfSize = 1e-4f, kOfPlace = 1e-5f;
  const float room = kOfSize * length(box.high - box.low) + kOfPlace * (length(box.low) + length(box.high));
  const Vec3 all = Vec3{1, 1, 1} * room;
  box.low = box.low - all, box.high = box.high + all;
  return box;
}

bool anyEmits(const Scene& scene, const std::vector<char>& moves) {
  const auto isMovingLamp = [&](const auto& shape) {
    return shape.body != kStands && moves[static_cast<std::size_t>(shape.body)] && emits(shape);
  };
  return std::ranges::any_of(scene.meshes, isMovingLamp) || std::ranges::any_of(scene.spheres, isMovingLamp);
}

}  // namespace

MovedBodies::MovedBodies(const PosedScene& now, const PosedScene& before) {
  if (!now.bodies()) return;
  const Scene& scene = now.still().description();
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const RigidMotion &a = now.bodies()->motions()[i], &b = before.bodies()->motions()[i];
    moves_.push_back(a != b);
    if (a == b) continue;
    ShapeBox& box = boxes_.emplace_back();
    addMoved(scene.bodies[i], a, box), addMoved(scene.bodies[i], b, box);
    wide_boxes_.push_back(widened(box));
  }
  lamps_move_ = any() && now.bodies()->lamps() && anyEmits(scene, moves_);
  if (wide_boxes_.size() <= kMostTested) return;
  ShapeBox all;
  for (const ShapeBox& box : wide_boxes_) all.add(box.low), all.add(box.high);
  wide_boxes_.assign(1, all);
}

}  // namespace saccade
