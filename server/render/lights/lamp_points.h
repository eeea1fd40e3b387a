// Points on the lamps whose light has a closed form, chosen by what each side of a lamp gives to one point.
#pragma once

#include <array>

#include "render/lights/analytic_light.h"

namespace saccade {

class LampPoints {
 public:
  // `strengths`: of the lamps. `reflectance`: of the surface, which weighs the lamps' colours.
  LampPoints(const AnalyticLight& light, const LitPoint& from, Rgb reflectance,
             const EmitterStrengths& strengths);

  bool empty() const { return count_ == 0; }  // no lamp lights the point

  struct Point {
    Vec3 position;
    float weight;  // of its light: the mean over all points is 1
  };
  // u chooses the side, u1 and u2 the place on it, each in [0, 1).
  Point at(float u, float u1, float u2) const;

 private:
  LitPoint from_;
  std::array<const AnalyticLight::Side*, AnalyticLight::kMaxSides> sides_;
  std::array<float, AnalyticLight::kMaxSides> factors_;  // share of the hemisphere that a side covers
  std::array<float, AnalyticLight::kMaxSides> sums_;     // of the light of the sides so far
  int count_ = 0;
};

}  // namespace saccade
