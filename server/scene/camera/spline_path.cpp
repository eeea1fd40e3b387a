#include "scene/camera/spline_path.h"

#include <array>
#include <cmath>

namespace saccade {
namespace {

// Shares of the steps from control to control: sums of basis functions.
struct Shares {
  double u1, u2, u3;
};

Shares sharesAt(double s) {
  return {(5 + s * (3 + s * (s - 3))) / 6, (1 + s * (3 + s * (3 - 2 * s))) / 6, s * s * s / 6};
}
Shares slopesAt(double s) {
  return {(1 - s) * (1 - s) / 2, (1 + 2 * s * (1 - s)) / 2, s * s / 2};
}

// The four controls of the span from control `whole` to the next.
template <class T>
std::array<T, 4> controlsOf(const std::vector<T>& loop, double whole) {
  const auto size = std::ssize(loop);
  const auto at = [&](std::ptrdiff_t i) { return loop[static_cast<std::size_t>((i % size + size) % size)]; };
  const auto i = static_cast<std::ptrdiff_t>(whole);
  return {at(i - 1), at(i), at(i + 1), at(i + 2)};
}

struct Span {
  std::array<Pose, 4> poses;
  std::array<Vec3d, 3> turns;  // from each to the next
  double s;                    // of the span, that has passed
};

Span spanAt(const SplinePath& path, TimeNs t) {
  const TimeNs in_period = (t % path.period + path.period) % path.period;
  const double u = seconds(in_period) / seconds(path.period) * static_cast<double>(path.controls.size());
  Span span{controlsOf(path.controls, std::floor(u)), {}, u - std::floor(u)};
  for (std::size_t i = 0; i < 3; ++i)
    span.turns[i] = rotationVector(conjugate(span.poses[i].rotation) * span.poses[i + 1].rotation);
  return span;
}

Vec3d weighted(const Span& span, const Shares& share) {
  const auto step = [&](std::size_t i) { return span.poses[i + 1].position - span.poses[i].position; };
  return step(0) * share.u1 + step(1) * share.u2 + step(2) * share.u3;
}

Vec3d rotateBack(Vec3d turn, Vec3d v) {
  return rotate(axisAngle(-turn), v);
}

}  // namespace

Vec3d loopAt(const std::vector<Vec3d>& controls, double u) {
  const double whole = std::floor(u);
  const auto c = controlsOf(controls, whole);
  const Shares share = sharesAt(u - whole);
  return c[0] + (c[1] - c[0]) * share.u1 + (c[2] - c[1]) * share.u2 + (c[3] - c[2]) * share.u3;
}

Pose SplinePath::at(TimeNs t) const {
  const Span span = spanAt(*this, t);
  const Shares share = sharesAt(span.s);
  const Quaternion turned = axisAngle(span.turns[0] * share.u1) * axisAngle(span.turns[1] * share.u2) *
                            axisAngle(span.turns[2] * share.u3);
  return {span.poses[0].position + weighted(span, share), normalize(span.poses[0].rotation * turned)};
}

// Each factor of the rotation turns about an axis of its own; the factors after it turn that axis.
Velocity SplinePath::velocityAt(TimeNs t) const {
  const Span span = spanAt(*this, t);
  const Shares share = sharesAt(span.s), slope = slopesAt(span.s);
  const Vec3d second =
      span.turns[1] * slope.u2 + rotateBack(span.turns[1] * share.u2, span.turns[0] * slope.u1);
  const Vec3d angular = span.turns[2] * slope.u3 + rotateBack(span.turns[2] * share.u3, second);
  const double per_s = static_cast<double>(controls.size()) / seconds(period);
  return {weighted(span, slope) * per_s, angular * per_s};
}

}  // namespace saccade
