#include "render/lights/sphere_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/lights/circle.h"

namespace saccade {
namespace {

constexpr double kPi = std::numbers::pi;

// A circle of directions: center + cos(phi) x + sin(phi) y.
struct Circle {
  Vec3d center, x, y;
  // The part above the plane with normal g.
  Interval above(Vec3d g) const {
    const double gx = dot(g, x), gy = dot(g, y);
    return positive(dot(g, center), std::hypot(gx, gy), std::atan2(gy, gx));
  }
  // Twice the vector area that an arc spans with the origin.
  Vec3d area(double begin, double end) const {
    const double sines = std::sin(end) - std::sin(begin), cosines = std::cos(end) - std::cos(begin);
    return cross(center, y) * sines + cross(center, x) * cosines + cross(x, y) * (end - begin);
  }
};

// `up` and `axis`: unit. A frame whose z is `along`, with x towards `up`.
struct Frame {
  Frame(Vec3d along, Vec3d up) {
    const Vec3d side = up - along * dot(up, along);
    const Vec3d any = std::abs(along.x) < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
    x = normalize(dot(side, side) > 1e-24 ? side : any - along * dot(any, along));
    y = cross(along, x);
  }
  Vec3d x, y;
};

// A cap of directions about an axis, of this cosine, cut by the planes with the normals n and g.
class CutCap {
 public:
  CutCap(Vec3d axis, double cosine, Vec3d n, Vec3d g)
      : axis_(axis), cosine_(cosine), n_(n), g_(g), is_one_(dot(n - g, n - g) < 1e-12) {}

  // Stokes' theorem: half of the edge's vector area, times n, is what the cap covers, times pi. [ours], with
  // one plane [Snyder 1996].
  double share() const {
    double twice = ofEdge() + ofHorizon(n_, g_);
    if (!is_one_) twice += ofHorizon(g_, n_);
    return std::max(0., twice / (2 * kPi));
  }

 private:
  // Of the cap's own edge.
  double ofEdge() const {
    const double sine = std::sqrt(1 - cosine_ * cosine_);
    const Frame frame(axis_, n_);
    const Circle edge{axis_ * cosine_, frame.x * sine, frame.y * sine};
    double sum = 0;
    forEachCommon({0, edge.above(n_).half}, is_one_ ? Interval{0, kPi} : edge.above(g_),
                  [&](double begin, double end) { sum += dot(n_, edge.area(begin, end)); });
    return sum;
  }
  // Of the plane with normal `along`, inside the cap and above the other plane.
  double ofHorizon(Vec3d along, Vec3d other) const {
    const Frame frame(along, axis_);
    const Circle horizon{{}, frame.x, frame.y};
    const Interval inside = positive(-cosine_, dot(axis_, frame.x), 0);
    double sum = 0;
    forEachCommon(inside, is_one_ ? Interval{0, kPi} : horizon.above(other),
                  [&](double begin, double end) { sum += dot(n_, horizon.area(begin, end)); });
    return sum;
  }

  Vec3d axis_;
  double cosine_;
  Vec3d n_, g_;
  bool is_one_;
};

}  // namespace

float sphereFormFactor(Vec3 center, float radius, const LitPoint& p) {
  const Vec3 to_center = center - p.point;
  const float distance2 = dot(to_center, to_center), distance = std::sqrt(distance2);
  if (!(distance > radius)) return 0;
  const float height = dot(to_center, p.normal), geometric = dot(to_center, p.geometric_normal);
  if (height <= -radius || geometric <= -radius) return 0;
  if (height >= radius && geometric >= radius) return radius * radius * height / (distance2 * distance);
  const double sine = double{radius} / double{distance};
  return static_cast<float>(CutCap(toDouble(to_center) / double{distance}, std::sqrt(1 - sine * sine),
                                   toDouble(p.normal), toDouble(p.geometric_normal))
                                .share());
}

}  // namespace saccade
