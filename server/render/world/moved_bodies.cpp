#include "render/world/moved_bodies.h"

namespace saccade {
namespace {

constexpr std::size_t kMostBoxes = 16;  // that each ray and each point is tested against

void addBody(const PosedBodies& bodies, std::size_t body, ShapeBox& box) {
  const ShapeBox rest = bodies.box(body);
  for (int i = 0; i < 8; ++i)
    box.add(bodies.motions()[body].point({i & 1 ? rest.high.x : rest.low.x, i & 2 ? rest.high.y : rest.low.y,
                                          i & 4 ? rest.high.z : rest.low.z}));
}

// With room for what Embree rounds.
ShapeBox widened(ShapeBox box) {
  constexpr float kOfSize = 1e-4f, kOfPlace = 1e-5f;
  const float room = kOfSize * length(box.high - box.low) + kOfPlace * (length(box.low) + length(box.high));
  const Vec3 all = Vec3{1, 1, 1} * room;
  box.low = box.low - all, box.high = box.high + all;
  return box;
}

// Joins boxes that follow each other along the longest axis, so that at most kMostBoxes are left.
std::vector<ShapeBox> joined(std::vector<ShapeBox> boxes) {
  if (boxes.size() <= kMostBoxes) return boxes;
  ShapeBox all;
  for (const ShapeBox& box : boxes) all.add(box);
  const Vec3 size = all.high - all.low;
  const auto place = [&](const ShapeBox& box) {
    const Vec3 at = box.centre();
    return size.x >= std::max(size.y, size.z) ? at.x : size.y >= size.z ? at.y : at.z;
  };
  std::ranges::stable_sort(boxes, {}, place);
  std::vector<ShapeBox> few(kMostBoxes);
  for (std::size_t i = 0; i < boxes.size(); ++i) few[i * kMostBoxes / boxes.size()].add(boxes[i]);
  return few;
}

}  // namespace

MovedBodies::MovedBodies(const PosedScene& now, const PosedScene& before) {
  if (!now.bodies()) return;
  before_ = before.bodies();
  const Scene& scene = now.still().description();
  const PosedLamps* lamps = now.bodies()->lamps();
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    moves_.push_back(!now.bodies()->equals(*before.bodies(), i));
    if (!moves_.back()) continue;
    any_ = true, lamps_move_ = lamps_move_ || (lamps && lamps->bodies[i]);
    if (!scene.bodies[i].has_shapes) continue;
    ShapeBox& box = boxes_.emplace_back();
    addBody(*now.bodies(), i, box), addBody(*before.bodies(), i, box);
  }
  boxes_ = joined(std::move(boxes_));
  for (const ShapeBox& box : boxes_) wide_boxes_.push_back(widened(box));
}

}  // namespace saccade
