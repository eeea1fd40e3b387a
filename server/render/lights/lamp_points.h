// Points on the lamps whose light has a closed form, chosen by what each side of a lamp gives to one point of
// a surface. They lie where the surface sees the side above its horizon.
#pragma once

#include <array>

#include "render/lights/analytic_light.h"

namespace saccade {

class LampPoints {
 public:
  LampPoints(const AnalyticLight& light, const EmitterStrengths& strengths)
      : light_(light), strengths_(strengths) {}

  // All that follows is of this surface. `reflectance` weighs the colours of lamps.
  void lookFrom(const LitPoint& from, Rgb reflectance);

  // Luminance that the surface reflects of a group of lamps, as if nothing cast a shadow.
  float unoccluded(int group) const { return unoccluded_[group]; }

  struct Point {
    Vec3 position;
    float weight;  // of its light: the mean over a group is 1
  };
  // A point of a group that lights the surface. u chooses the side, u1 and u2 the place on it, in [0, 1).
  Point at(int group, float u, float u1, float u2) const;

 private:
  struct Seen {
    const AnalyticLight::Side* side = nullptr;
    Polygon part;                                     // of a polygon, from the surface; of others empty
    bool is_parallelogram = false;                    // that part
    std::array<float, Polygon::kMaxCorners> areas{};  // of a fan of triangles, up to each corner
    float form_factor = 0;
    float weight = 0;  // of its points: area / (pi * form factor)
    float sum = 0;     // of the light of its group, up to this side
  };
  static void measure(Seen& seen);

  const AnalyticLight& light_;
  const EmitterStrengths& strengths_;
  LitPoint from_;
  std::array<Seen, AnalyticLight::kMaxSides> seen_;        // group by group
  std::array<int, AnalyticLight::kMaxGroups + 1> ends_{};  // of the groups before each
  std::array<float, AnalyticLight::kMaxGroups> unoccluded_{};
};

}  // namespace saccade
