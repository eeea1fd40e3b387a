// Lamps as several points see them at once: the share of each point's hemisphere that a lamp covers.
#pragma once

#include <numbers>
#include <span>

#include "base/lane_vectors.h"
#include "render/lights/disk_light.h"
#include "render/lights/lamp_front.h"

namespace saccade {

// angle / sin(angle) of an angle with this cosine, to 5e-7: a polynomial fitted to acos(c) / sqrt(1 - c^2) on
// [0, 1].
template <class F>
[[gnu::always_inline]] inline F angleOverSine(F cosine) {
  using std::abs, std::max, std::sqrt;
  const F c = abs(cosine);
  F f = -0.02735403f;
  for (const float k : {0.1384896f, -0.327471f, 0.5115087f, -0.6495042f, 0.7834481f, -0.9999133f, 1.570796f})
    f = f * c + k;
  return select(cosine >= 0.f, f, F(std::numbers::pi_v<float> / sqrt(max(F(1e-12f), 1.f - c * c)) - f));
}

class LampLanes {
 public:
  static constexpr int kLanes = 8;
  using F = Floats<kLanes>;
  using V = Vec3T<F>;

  // `lanes`: those whose results count.
  LampLanes(const LaneVectors& points, const LaneVectors& normals, const LaneVectors& geometric_normals,
            int first, LaneSet lanes)
      : point_(points.lanes<kLanes>(first)),
        normal_(normals.lanes<kLanes>(first)),
        geometric_normal_(geometric_normals.lanes<kLanes>(first)),
        lanes_(lanes) {}

  // Of a convex polygon that shines to the side of `lit` [Lambert 1760].
  F formFactor(std::span<const Vec3> corners, Vec3 lit) const {
    const M front = seesLamp<F>(point_, corners, lit);
    M all = front, any(false), any_geometric(false);  // of the corners are above the horizon
    for (const Vec3 corner : corners) {
      const V w = splat<F>(corner) - point_;
      const M above = dot(w, normal_) > 0.f, above_geometric = dot(w, geometric_normal_) > 0.f;
      all = all && above && above_geometric;
      any = any || above, any_geometric = any_geometric || above_geometric;
    }
    const M cut = front && any && any_geometric && !all;
    if (!(lanesOf(cut) & lanes_).any()) return select(all, ofWhole(corners), 0.f);
    return select(all || cut, ofPart(corners), 0.f);
  }

  // Of a disk; in the lanes of `cut` a horizon cuts it, and they hold nothing.
  F diskFormFactor(const Disk& disk, LaneSet& cut) const {
    const V to_center = splat<F>(disk.center) - point_;
    const M front = seesDisk<F>(to_center, disk);
    const F height = dot(to_center, normal_), reach = reachOf<F>(disk, normal_);
    const F geometric = dot(to_center, geometric_normal_),
            geometric_reach = reachOf<F>(disk, geometric_normal_);
    const M whole = front && height >= reach && geometric >= geometric_reach;
    cut = lanesOf(front && !whole && height > -reach && geometric > -geometric_reach) & lanes_;
    return select(whole, wholeFormFactor<F>(disk, to_center, normal_), F(0.f));
  }

  // Of a sphere; in the lanes of `cut` a horizon cuts it, and they hold nothing.
  F sphereFormFactor(Vec3 center, float radius, LaneSet& cut) const {
    const V to_center = splat<F>(center) - point_;
    const F distance2 = dot(to_center, to_center), height = dot(to_center, normal_);
    const F lower = stdx::min(height, dot(to_center, geometric_normal_));
    const M outside = distance2 > radius * radius, whole = outside && lower >= radius;
    cut = lanesOf(outside && !whole && lower > -radius) & lanes_;
    return select(whole, radius * radius * height / (distance2 * sqrt(distance2)), F(0.f));
  }

 private:
  using M = Mask<kLanes>;

  // A side of a polygon, seen from the points; in lanes where there is one.
  struct Side {
    V a, b;
    M is;
  };
  // Cuts off what of a convex polygon is below a horizon.
  class Horizon {
   public:
    // `none`: where nothing is below.
    Horizon(const V& normal, const M& none) : normal_(normal), none_(none) {}
    // The part of a side that is above.
    Side above(const Side& side) {
      const F height_a = dot(side.a, normal_), height_b = dot(side.b, normal_);
      const M a = none_ || height_a > 0.f, b = none_ || height_b > 0.f;
      const V cut = side.a + (side.b - side.a) * F(height_a / (height_a - height_b));
      const M down = side.is && a && !b, up = side.is && !a && b;
      down_ = selectLanes(down, cut, down_), is_down_ = is_down_ || down;
      up_ = selectLanes(up, cut, up_), is_up_ = is_up_ || up;
      return {selectLanes(a, side.a, cut), selectLanes(b, side.b, cut), side.is && (a || b)};
    }
    // The side along the horizon, once all others were cut.
    Side along() const { return {down_, up_, is_down_ && is_up_}; }

   private:
    V normal_, down_, up_;  // where sides cross the horizon
    M none_, is_down_{false}, is_up_{false};
  };

  static V unit(const V& v) { return v * F(1.f / sqrt(dot(v, v))); }
  F ofSide(const V& a, const V& b) const { return angleOverSine<F>(dot(a, b)) * dot(normal_, cross(a, b)); }
  F ofSide(const Side& side) const { return select(side.is, ofSide(unit(side.a), unit(side.b)), 0.f); }
  static F shareOf(const F& sides) { return abs(sides) * (0.5f * std::numbers::inv_pi_v<float>); }

  F ofWhole(std::span<const Vec3> corners) const {
    const V first = unit(splat<F>(corners[0]) - point_);
    V a = first;
    F sum = 0.f;
    for (const Vec3 corner : corners.subspan(1)) {
      const V b = unit(splat<F>(corner) - point_);
      sum += ofSide(a, b);
      a = b;
    }
    return shareOf(sum + ofSide(a, first));
  }
  // Of what is above both horizons.
  F ofPart(std::span<const Vec3> corners) const {
    const M same = normal_.x == geometric_normal_.x && normal_.y == geometric_normal_.y &&
                   normal_.z == geometric_normal_.z;
    Horizon shading(normal_, M(false)), geometric(geometric_normal_, same);
    F sum = 0.f;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec3 next = corners[i + 1 < corners.size() ? i + 1 : 0];
      const Side side{splat<F>(corners[i]) - point_, splat<F>(next) - point_, M(true)};
      sum += ofSide(geometric.above(shading.above(side)));
    }
    sum += ofSide(geometric.above(shading.along()));
    return shareOf(sum + ofSide(geometric.along()));
  }

  V point_, normal_, geometric_normal_;
  LaneSet lanes_;
};

}  // namespace saccade
