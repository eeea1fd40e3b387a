#include "render/world/changing_light.h"

namespace saccade {
namespace {

// A disk or a sphere has one corner, its centre.
void addLamp(const AnalyticLight::Side& side, ShapeBox& box) {
  const Vec3 half = Vec3{1, 1, 1} * side.radius;
  for (const Vec3 corner : side.corners) box.add(corner - half), box.add(corner + half);
}

// The part of [first, last] in which p (1 - s) + s [low, high] meets [least, most], along one axis.
struct Part {
  void meet(float p, float low, float high, float least, float most) {
    clip(p - most, low - p);    // p + s (low - p) <= most
    clip(least - p, p - high);  // p + s (high - p) >= least
  }
  // Leaves a + s b <= 0.
  void clip(float a, float b) {
    if (b == 0) {
      if (a > 0) last = -1;
    } else if (b > 0) {
      last = std::min(last, -a / b);
    } else {
      first = std::max(first, -a / b);
    }
  }
  bool empty() const { return first > last; }

  float first = 0, last = 1;
};

// Whether the hull of a point and a box meets another box.
bool meets(Vec3 p, const ShapeBox& lamp, const ShapeBox& body) {
  Part part;
  part.meet(p.x, lamp.low.x, lamp.high.x, body.low.x, body.high.x);
  part.meet(p.y, lamp.low.y, lamp.high.y, body.low.y, body.high.y);
  part.meet(p.z, lamp.low.z, lamp.high.z, body.low.z, body.high.z);
  return !part.empty();
}

}  // namespace

ChangingLight::ChangingLight(const PosedScene& now, const PosedScene& before, const MovedBodies& moved)
    : moved_(moved) {
  if (!moved.any()) return;
  lamps_.resize(static_cast<std::size_t>(now.analyticLight().groups()));
  for (const PosedScene* scene : {&now, &before})
    for (const AnalyticLight::Side& side : scene->analyticLight().sides())
      addLamp(side, lamps_[static_cast<std::size_t>(side.group)]);
}

bool ChangingLight::at(Vec3 point) const {
  for (const ShapeBox& body : moved_.boxes())
    for (const ShapeBox& lamp : lamps_)
      if (meets(point, lamp, body)) return true;
  return false;
}

}  // namespace saccade
