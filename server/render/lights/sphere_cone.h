// A sphere as a point outside sees it: the directions of a cone.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/vec.h"
#include "render/bsdf/shading_frame.h"

namespace saccade {

class SphereCone {
 public:
  SphereCone(Vec3 from, Vec3 center, float radius) : radius2_(radius * radius) {
    const Vec3 to_center = center - from;
    distance_ = length(to_center);
    axis_ = to_center / distance_;
    const float sine = radius / distance_;
    if (sine < 1) less_ = sine * sine / (1 + std::sqrt((1 - sine) * (1 + sine)));
  }

  bool isOutside() const { return less_ > 0; }  // else the sphere gives the point no light
  float solidAngle() const { return 2 * std::numbers::pi_v<float> * less_; }

  // Unit, uniform in the cone, of two numbers in [0, 1).
  struct Direction {
    Vec3 w;
    float distance;  // to the sphere
  };
  Direction at(float u1, float u2) const {
    const float less = u1 * less_, sin2 = less * (2 - less);  // less than 1: of the cosine with the axis
    const float r = std::sqrt(sin2), turn = 2 * std::numbers::pi_v<float> * u2;
    const Vec3 w = ShadingFrame<float>(axis_).toWorld({r * std::cos(turn), r * std::sin(turn), 1 - less});
    const float half_chord2 = radius2_ - distance_ * distance_ * sin2;
    return {w, distance_ * (1 - less) - std::sqrt(std::max(0.f, half_chord2))};
  }

 private:
  float radius2_, distance_;
  Vec3 axis_;
  float less_ = 0;  // 1 - the cosine of the cone
};

}  // namespace saccade
