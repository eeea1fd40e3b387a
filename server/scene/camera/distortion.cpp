#include "scene/camera/distortion.h"

#include <cmath>
#include <numbers>

namespace saccade {
namespace {

constexpr double kLeastDeterminant = 5e-4;  // of a slope; where it is 0 the lens folds
constexpr double kTolerance = 1e-12;        // of the inverse, focal lengths
constexpr int kMostSteps = 20;              // of Newton's method
constexpr int kWalk = 32;                   // steps from the centre

// 1 + k1 s + k2 s^2 + ... of `count` coefficients.
double series(const double* k, int count, double s) {
  double sum = 0;
  for (int i = count; i-- > 0;) sum = (sum + k[i]) * s;
  return 1 + sum;
}

PlanePoint distortRadTan(const Distortion& lens, PlanePoint p) {
  const auto [k1, k2, p1, p2, k3] = lens.k;
  const double r2 = p.x * p.x + p.y * p.y, radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
  return {p.x * radial + 2 * p1 * p.x * p.y + p2 * (r2 + 2 * p.x * p.x),
          p.y * radial + p1 * (r2 + 2 * p.y * p.y) + 2 * p2 * p.x * p.y};
}

PlaneMap slopeOfRadTan(const Distortion& lens, PlanePoint p) {
  const auto [k1, k2, p1, p2, k3] = lens.k;
  const double r2 = p.x * p.x + p.y * p.y, radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
  const double by_r2 = k1 + r2 * (2 * k2 + r2 * 3 * k3);
  const double mixed = 2 * (p.x * p.y * by_r2 + p1 * p.x + p2 * p.y);
  return {radial + 2 * p.x * p.x * by_r2 + 2 * p1 * p.y + 6 * p2 * p.x, mixed, mixed,
          radial + 2 * p.y * p.y * by_r2 + 6 * p1 * p.y + 2 * p2 * p.x};
}

// The angle at which the lens shows the angle `theta`, over the latter.
double angleRatio(const Distortion& lens, double theta) {
  return series(lens.k.data(), 4, theta * theta);
}

PlanePoint distortEquidistant(const Distortion& lens, PlanePoint p) {
  const double r = std::hypot(p.x, p.y), theta = std::atan(r);
  const double scale = (r > 0 ? theta / r : 1) * angleRatio(lens, theta);
  return {p.x * scale, p.y * scale};
}

PlaneMap slopeOfEquidistant(const Distortion& lens, PlanePoint p) {
  const double r = std::hypot(p.x, p.y), theta = std::atan(r), r2 = r * r;
  const double across = (r > 0 ? theta / r : 1) * angleRatio(lens, theta);
  const std::array<double, 4> by_theta{3 * lens.k[0], 5 * lens.k[1], 7 * lens.k[2], 9 * lens.k[3]};
  const double along = series(by_theta.data(), 4, theta * theta) / (1 + r2);
  const double bend = r2 > 0 ? (along - across) / r2 : 0;
  return {across + bend * p.x * p.x, bend * p.x * p.y, bend * p.x * p.y, across + bend * p.y * p.y};
}

}  // namespace

PlanePoint distort(const Distortion& lens, PlanePoint p) {
  return lens.model == LensModel::kRadTan ? distortRadTan(lens, p) : distortEquidistant(lens, p);
}

PlaneMap distortionSlope(const Distortion& lens, PlanePoint p) {
  return lens.model == LensModel::kRadTan ? slopeOfRadTan(lens, p) : slopeOfEquidistant(lens, p);
}

std::optional<PlanePoint> undistort(const Distortion& lens, PlanePoint shown, PlanePoint start) {
  PlanePoint p = start;
  for (int step = 0; step < kMostSteps; ++step) {
    const PlanePoint at = distort(lens, p), left{shown.x - at.x, shown.y - at.y};
    const PlaneMap slope = distortionSlope(lens, p);
    const double determinant = slope.determinant();
    if (!(determinant > kLeastDeterminant)) return {};
    p.x += (slope.yy * left.x - slope.xy * left.y) / determinant;
    p.y += (slope.xx * left.y - slope.yx * left.x) / determinant;
    if (std::hypot(left.x, left.y) < kTolerance) return p;
  }
  return {};
}

std::optional<PlanePoint> undistortFromCentre(const Distortion& lens, PlanePoint shown) {
  const double most = std::tan(kMaxLensAngleDeg * std::numbers::pi / 180);
  PlanePoint p;
  for (int i = 1; i <= kWalk; ++i) {
    const double share = static_cast<double>(i) / kWalk;
    const auto next = undistort(lens, {shown.x * share, shown.y * share}, p);
    if (!next || !(std::hypot(next->x, next->y) <= most)) return {};
    p = *next;
  }
  return p;
}

}  // namespace saccade
