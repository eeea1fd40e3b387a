// The light of points and spots on a surface as if nothing cast a shadow, in lanes: to choose among many.
#pragma once

#include <cmath>
#include <numbers>
#include <span>

#include "base/wide.h"
#include "render/lights/lamp_picks.h"
#include "scene/scene.h"

namespace saccade {

class SpotWeights {
 public:
  // At most LampPicks::kMost. A point is a spot that shines everywhere.
  explicit SpotWeights(std::span<const SpotLight> spots) : count_(spots.size()) {
    for (std::size_t i = 0; i < count_; ++i) {
      const SpotLight& s = spots[i];
      x_[i] = s.position.x, y_[i] = s.position.y, z_[i] = s.position.z;
      axis_x_[i] = s.axis.x, axis_y_[i] = s.axis.y, axis_z_[i] = s.axis.z;
      dark_[i] = s.beam < std::numbers::pi_v<float> ? std::cos(s.cutoff) : -2;
      strength_[i] = luminance(s.intensity);
    }
    for (std::size_t i = count_; i % kLanes != 0; ++i)
      x_[i] = y_[i] = z_[i] = axis_x_[i] = axis_y_[i] = axis_z_[i] = dark_[i] = strength_[i] = 0;
  }

  std::size_t size() const { return count_; }
  // Writes the light of each lamp that a surface reflects, but for the falloff within cones. There are as
  // many numbers as lamps, rounded up to eight, aligned to 32 bytes. `normal`: unit, times the reflectance
  // over pi.
  void at(Vec3 point, Vec3 normal, float* weights) const {
    for (std::size_t i = 0; i < count_; i += kLanes) {
      const F x = load<kLanes>(x_ + i) - point.x, y = load<kLanes>(y_ + i) - point.y,
              z = load<kLanes>(z_ + i) - point.z;
      const F d2 = x * x + y * y + z * z, d = sqrt(d2);
      const F facing = x * normal.x + y * normal.y + z * normal.z;
      const F along =
          -(x * load<kLanes>(axis_x_ + i) + y * load<kLanes>(axis_y_ + i) + z * load<kLanes>(axis_z_ + i));
      const auto lit = facing > 0.f && along > load<kLanes>(dark_ + i) * d;
      store(select(lit, load<kLanes>(strength_ + i) * facing / (d2 * d), F(0.f)), weights + i);
    }
  }

 private:
  static constexpr int kLanes = 8;
  using F = Floats<kLanes>;
  static constexpr std::size_t kMost = LampPicks::kMost;
  static_assert(kMost % kLanes == 0);

  std::size_t count_;
  alignas(64) float x_[kMost], y_[kMost], z_[kMost];
  alignas(64) float axis_x_[kMost], axis_y_[kMost], axis_z_[kMost];
  alignas(64) float dark_[kMost], strength_[kMost];  // the cosine of the cutoff; luminance at the distance 1
};

}  // namespace saccade
