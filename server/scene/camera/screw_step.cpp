#include "scene/camera/screw_step.h"

#include <cmath>

namespace saccade {
namespace {

// V(w) v, where exp(w, v) has the translation V(w) v: what is travelled while turning.
Vec3d travelled(Vec3d w, Vec3d v) {
  const double angle = length(w), angle2 = angle * angle;
  const double half = std::sin(angle / 2);
  const double a = angle < kSmallAngle ? 0.5 - angle2 / 24 : 2 * half * half / angle2;
  const double b =
      angle < kSmallAngle ? 1.0 / 6 - angle2 / 120 : (angle - std::sin(angle)) / (angle2 * angle);
  const Vec3d wv = cross(w, v);
  return v + wv * a + cross(w, wv) * b;
}

}  // namespace

Pose screwStep(Vec3d turn, Vec3d travel) {
  return {travelled(turn, travel), axisAngle(turn)};
}

}  // namespace saccade
