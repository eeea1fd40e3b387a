// Shadow rays from the points of a frame to groups of lamps, and what they have found so far.
#pragma once

#include <span>
#include <vector>

#include "frame/surface_samples.h"
#include "render/tiles/surface_start.h"
#include "render/world/posed_scene.h"

namespace saccade {

// The surfaces of a frame, and where paths start from them.
struct FrameStarts {
  const PosedScene& scene;
  const SurfaceSamples& on;
  const SurfaceStarts& starts;
};

// The rays of a point to one group of lamps.
struct LampRays {
  float visible = 0, all = 0;  // sums of weights
  float unoccluded = 0;        // light of the group
  int count = 0;

  bool anyLit() const { return visible > 0; }
  bool anyDark() const { return visible < all; }
  bool areMixed() const { return anyLit() && anyDark(); }
  float visibility() const { return all > 0 ? visible / all : 1; }
};

// Variance of visibility that rays to groups of lamps leave, in the middle of a penumbra but for its edges.
// `squares`: of the light of these groups, over the squared light of all.
inline float varianceOfRays(float squares, int rays) {
  constexpr float kOfOne = 0.16f;  // V (1 - V)
  return kOfOne * squares / static_cast<float>(rays);
}
// The least that rays must lessen, over the variance that they leave.
inline constexpr float kLeastRayGain = 0.25f;

// The light of all groups at a point.
struct LampSums {
  explicit LampSums(std::span<const LampRays> of_groups) {
    for (const LampRays& rays : of_groups) {
      const float V = rays.visibility(), U = rays.unoccluded;
      light += U, visible += U * V;
      if (!rays.areMixed()) continue;
      variance += U * U * V * (1 - V) / static_cast<float>(rays.count), mixed2 += U * U;
    }
  }
  // `of_visible`: variance of `visible`.
  RayVisibility visibility(float wanted, float of_visible) const {
    const float of_mean = relativeVariance(of_visible);
    return {light > 0 ? visible / light : 1, wanted / (wanted + of_mean), of_mean};
  }
  float relativeVariance(float v) const { return light > 0 ? v / (light * light) : 0; }

  float light = 0, visible = 0, variance = 0;  // of `visible`
  float mixed2 = 0;                            // squared light of groups whose rays areMixed()
};

// A point that wants rays to some groups: bit g stands for group g.
struct RayRequest {
  std::uint32_t point;
  std::uint32_t groups;
};

// The rays of all points of a frame.
class FrameRays {
 public:
  void reset(std::size_t points, int groups);
  // Tells that trace() follows.
  void use() { used_ = true; }

  // Whether they are of so many points and groups.
  bool areOf(std::size_t points, int groups) const {
    return groups_ == groups && rays_.size() == points * static_cast<std::size_t>(groups);
  }

  int groups() const { return groups_; }
  const LampRays& at(std::size_t point, int group) const { return rays_[indexOf(point, group)]; }
  std::span<const LampRays> of(std::size_t point) const {
    return std::span(rays_).subspan(indexOf(point, 0), static_cast<std::size_t>(groups_));
  }

  // Forgets the rays of a point that has more than `most` to a group.
  void limit(std::size_t point, int most) {
    for (int g = 0; g < groups_; ++g)
      if (LampRays& rays = rays_[indexOf(point, g)]; rays.count > most) rays = {};
  }
  // Goes on until each request has `count` rays to each of its groups. Requests of different points may be
  // traced at the same time.
  void trace(const FrameStarts& frame, std::span<const RayRequest> requests, int count);
  // Whether some rays of a point and its neighbours on the same surface are blocked and others are not, as in
  // a penumbra.
  bool areMixedAround(const SurfaceSamples& on, std::uint32_t point, int group) const;

 private:
  template <Shading S>
  void traceWith(const FrameStarts& frame, std::span<const RayRequest> requests, int count);
  std::size_t indexOf(std::size_t point, int group) const {
    return point * static_cast<std::size_t>(groups_) + static_cast<std::size_t>(group);
  }

  int groups_ = 0;
  bool used_ = false;           // since reset()
  std::vector<LampRays> rays_;  // by point and group
};

}  // namespace saccade
