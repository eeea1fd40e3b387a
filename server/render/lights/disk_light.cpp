#include "render/lights/disk_light.h"

#include <numbers>

#include "render/lights/analytic_light.h"
#include "render/lights/circle.h"

namespace saccade {
namespace {

constexpr double kPi = std::numbers::pi;

// A disk cut by the planes through the origin with the normals n and g. Its form factor is the integral
// of n (r x dr) / r^2 along its edges, over 2 pi [Lambert 1760].
class CutDisk {
 public:
  CutDisk(const Disk& disk, Vec3d center, Vec3d n, Vec3d g)
      : center_(center), n_(n), g_(g), is_one_(dot(n - g, n - g) < 1e-12) {
    const Vec3d lit = toDouble(disk.normal), below = center - lit * dot(center, lit);
    const Vec3d other = cross(lit, std::abs(lit.x) < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0});
    const double radius = disk.radius;
    x_ = normalize(dot(below, below) > 1e-24 * radius * radius ? below : other) * radius;
    y_ = cross(x_, lit);
  }

  double share() const {
    const Interval above = above_(n_), other = above_(g_);
    double twice = 0;
    forEachCommon(above, is_one_ ? Interval{0, kPi} : other,
                  [&](double begin, double end) { twice += ofArc(end) - ofArc(begin); });
    twice += ofChord(above, g_);
    if (!is_one_) twice += ofChord(other, n_);
    return std::max(0., twice / (2 * kPi));
  }

 private:
  Vec3d at(double phi) const { return center_ + x_ * std::cos(phi) + y_ * std::sin(phi); }
  // The part of the edge above the plane with normal m.
  Interval above_(Vec3d m) const {
    const double mx = dot(m, x_), my = dot(m, y_);
    return positive(dot(m, center_), std::hypot(mx, my), std::atan2(my, mx));
  }

  // From some angle on to phi, along the edge. There r^2 = A + B cos, because y is at a right angle to the
  // centre.
  double ofArc(double phi) const {
    constexpr double kNone = 1e-6;  // of B / A: then r is constant
    const double A = dot(center_, center_) + dot(x_, x_), B = 2 * dot(center_, x_), k = B / A;
    const double of_one = dot(n_, cross(x_, y_)), of_cosine = dot(n_, cross(center_, y_)),
                 of_sine = -dot(n_, cross(center_, x_));
    const double turns = std::round(phi / (2 * kPi)), half = phi / 2 - kPi * turns;
    const double inverse = 2 / std::sqrt((A - B) * (A + B)) *
                           (std::atan(std::sqrt((A - B) / (A + B)) * std::tan(half)) + kPi * turns);
    const double cosine = std::cos(phi);
    if (k < kNone) return of_one * inverse + (of_cosine * std::sin(phi) - of_sine * cosine) / A;
    return of_one * inverse + of_cosine * (phi - A * inverse) / B - of_sine * std::log1p(k * cosine) / B;
  }

  // Of the straight edge that closes an arc, above the plane with normal m.
  double ofChord(Interval arc, Vec3d m) const {
    if (!(arc.half > 0 && arc.half < kPi)) return 0;
    Vec3d a = at(arc.middle + arc.half), b = at(arc.middle - arc.half);
    if (!is_one_) {
      const double height_a = dot(m, a), height_b = dot(m, b);
      if (height_a <= 0 && height_b <= 0) return 0;
      const Vec3d cut = a + (b - a) * (height_a / (height_a - height_b));
      if (height_a <= 0) a = cut;
      if (height_b <= 0) b = cut;
    }
    const Vec3d across = cross(a, b);
    const double size = length(across);
    return size > 0 ? std::atan2(size, dot(a, b)) * dot(n_, across) / size : 0;
  }

  Vec3d center_, x_, y_;  // from the origin; along the radii
  Vec3d n_, g_;
  bool is_one_;
};

}  // namespace

float diskFormFactor(const Disk& disk, const LitPoint& p) {
  const Vec3 to_center = disk.center - p.point;
  if (!seesDisk<float>(to_center, disk)) return 0;
  const float height = dot(to_center, p.normal), reach = reachOf<float>(disk, p.normal);
  const float geometric = dot(to_center, p.geometric_normal),
              its_reach = reachOf<float>(disk, p.geometric_normal);
  if (height <= -reach || geometric <= -its_reach) return 0;
  if (height >= reach && geometric >= its_reach) return wholeFormFactor<float>(disk, to_center, p.normal);
  return static_cast<float>(
      CutDisk(disk, toDouble(to_center), toDouble(p.normal), toDouble(p.geometric_normal)).share());
}

}  // namespace saccade
