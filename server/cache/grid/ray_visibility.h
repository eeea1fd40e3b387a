// Visibility by shadow rays: where the grid wants it, and how an estimate takes it in.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "cache/grid/surface_grid.h"

namespace saccade {

// Visibility by rays at a few points.
class RayLanes {
 public:
  RayLanes() = default;
  RayLanes(const PointLanes& lanes, const FrameOnGrid& frame) {
    if (!frame.shadows) return;
    for (int i = 0; i < lanes.count; ++i)
      set(i, (*frame.shadows)[frame.at.points[lanes.points[i]].index], frame.visibility);
  }
  // Takes that of a point, if it has rays.
  void set(int lane, const SurfaceShadow& s, RayVisibility SurfaceShadow::*visibility) {
    if (s.wanted <= 0) return;
    any_ = true;
    const RayVisibility& V = s.*visibility;
    memory_.set(lane, std::array{V.mean, V.trust, V.variance, s.step_variance});
  }
  bool any() const { return any_; }
  // Takes them into an estimate, as far as they are trusted.
  void refine(const LevelBlend<PointFloats>& blend, PointFloats U, PointFloats cells, PointFloats& i,
              PointFloats& variance, PointFloats& step_variance) const {
    const auto [V, trust, noise, step_noise] = memory_.lanes();
    const PointFloats of_rays = U * U * trust * trust, rest = U * U * (1.f - trust) * (1.f - trust);
    i += trust * U * (V - blend.visibility.value);
    variance = blend.residual.variance + rest * blend.visibility.variance + of_rays * noise;
    const PointFloats of_step = select(cells > 0.f, of_rays * step_noise, PointFloats(0.f));
    step_variance =
        blend.residual.stepVariance(cells) + rest * blend.visibility.stepVariance(cells) + of_step;
  }
  // Takes them into visibility, its variance and that of a step of motion. `moves`: where there is any.
  void refine(const auto& moves, PointFloats& visibility, PointFloats& variance,
              PointFloats& step_variance) const {
    const auto [V, trust, noise, step_noise] = memory_.lanes();
    const PointFloats of_rays = trust * trust, rest = (1.f - trust) * (1.f - trust);
    visibility += trust * (V - visibility);
    variance = rest * variance + of_rays * noise;
    step_variance = rest * step_variance + select(moves, PointFloats(of_rays * step_noise), PointFloats(0.f));
  }

 private:
  bool any_ = false;
  LaneMemory<4> memory_;
};

// Rays tell visibility where its standard deviation is this part of the light.
inline constexpr float kLeastShadowContrast = 0.05f;

// The variance of visibility within the finest cells, by the evidence for it, of weight above 0.
inline float visibilityDetail(const Octet& evidence) {
  constexpr float kTau = 0.5f;  // standard deviations that detail must exceed its noise by: rays do no harm
  return std::max(0.f, evidence[4] - kTau * std::sqrt(evidence[5])) / evidence[7];
}

// The variance of visibility where it is a visible part of the light, for rays to tell; otherwise 0. It is
// that of detail within the finest cells, by the evidence for it, and that of the mean [ours].
inline float shadowVariance(const Octet& evidence, float noise, float unoccluded, float light) {
  constexpr float kUnknown = 0.02f;
  constexpr float kLeastDoubt = 0.0025f;  // of V, that no evidence takes away: it counts where V is small
  if (!(evidence[7] > 0 && light > 0)) return kUnknown;
  const float variance = visibilityDetail(evidence) + noise + kLeastDoubt * kLeastDoubt;
  return unoccluded * std::sqrt(variance) > kLeastShadowContrast * light ? variance : 0;
}

// The variance of visibility that rays are to tell at a level of the grid, by its light and its evidence for
// detail.
inline float shadowVariance(const Quad& light, const Octet& evidence, float unoccluded,
                            const BlendParams& blend) {
  if (!(unoccluded > 0)) return 0;
  const float noise = varianceOf<float>(evidence[6], evidence[7], light[3], blend);
  // Not U V: where few samples have met a strong lamp that is hidden, V is far too large.
  return shadowVariance(evidence, noise, unoccluded, (light[1] + unoccluded * light[2]) / light[0]);
}

}  // namespace saccade
