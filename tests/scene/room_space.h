// The free space of a room with a ball in it, in closed form.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/camera/free_space.h"

namespace saccade::test {

// A box from 0 to `size` with walls of no thickness, and a ball within. Both have two sides.
struct RoomSpace : FreeSpace {
  Vec3d size{8, 3, 6}, centre{4, 1.5, 3};
  double radius = 1;

  double exactDistance(Vec3d p) const {
    const double ball = std::abs(length(p - centre) - radius);
    const double walls = std::min({p.x, size.x - p.x, p.y, size.y - p.y, p.z, size.z - p.z});
    return std::min(ball, walls >= 0 ? walls : outside(p));
  }
  double distance(Vec3d p, double reach) const override { return std::min(reach, exactDistance(p)); }
  void look(Vec3d from, std::span<const Vec3d> directions, std::span<double> distances) const override {
    for (std::size_t i = 0; i < directions.size(); ++i)
      distances[i] = std::min(toBall(from, directions[i]), toWalls(from, directions[i]));
  }

 private:
  static constexpr double kNever = std::numeric_limits<double>::infinity();

  double outside(Vec3d p) const {
    const auto beyond = [](double v, double most) { return std::max({0.0, -v, v - most}); };
    return length(Vec3d{beyond(p.x, size.x), beyond(p.y, size.y), beyond(p.z, size.z)});
  }
  double toBall(Vec3d from, Vec3d along) const {
    const Vec3d to = centre - from;
    const double ahead = dot(to, along), d = ahead * ahead - dot(to, to) + radius * radius;
    if (d < 0) return kNever;
    const double first = ahead - std::sqrt(d), second = ahead + std::sqrt(d);
    return first > 0 ? first : second > 0 ? second : kNever;
  }
  // From within.
  double toWalls(Vec3d from, Vec3d along) const {
    const auto toWall = [](double at, double step, double most) {
      if (step == 0) return kNever;
      return std::max(-at / step, (most - at) / step);
    };
    return std::min(
        {toWall(from.x, along.x, size.x), toWall(from.y, along.y, size.y), toWall(from.z, along.z, size.z)});
  }
};

}  // namespace saccade::test
