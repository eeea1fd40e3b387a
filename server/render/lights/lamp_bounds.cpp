#include "render/lights/lamp_bounds.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace saccade {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

// `axis` turned by `angle` towards `to`.
Vec3 turned(Vec3 axis, Vec3 to, float angle) {
  const Vec3 side = to - axis * dot(axis, to);
  const float length2 = dot(side, side);
  if (length2 <= 0) return axis;
  return axis * std::cos(angle) + side * (std::sin(angle) / std::sqrt(length2));
}

void mergeCones(const LampBounds& a, const LampBounds& b, LampBounds& out) {
  const LampBounds &wide = a.spread >= b.spread ? a : b, &narrow = a.spread >= b.spread ? b : a;
  const float between = std::acos(std::clamp(dot(wide.axis, narrow.axis), -1.f, 1.f));
  out.axis = wide.axis, out.spread = wide.spread;
  if (std::min(between + narrow.spread, kPi) <= wide.spread) return;
  out.spread = std::min(kPi, (wide.spread + between + narrow.spread) / 2);
  if (out.spread < kPi) out.axis = normalize(turned(wide.axis, narrow.axis, out.spread - wide.spread));
}

}  // namespace

LampBounds merged(const LampBounds& a, const LampBounds& b) {
  LampBounds out;
  out.low = {std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y), std::min(a.low.z, b.low.z)};
  out.high = {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y), std::max(a.high.z, b.high.z)};
  out.dark = std::min(a.dark, b.dark), out.bright = std::min(a.bright, b.bright);
  out.strength = a.strength + b.strength;
  mergeCones(a, b, out);
  return out;
}

}  // namespace saccade
