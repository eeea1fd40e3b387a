// The light that a bake knows at a few points, in lanes.
#pragma once

#include "cache/bake/baked_means.h"

namespace saccade {

class BakedBatch {
 public:
  // `scale`: of the residual that vertices keep.
  BakedBatch(const BakedPoints& points, const SurfaceSamples& on, const GBuffer& g, float scale,
             float cell_px);

  // Marks the points whose light is known, and of these the ones near a shadow's edge. Rays are wanted there
  // where the edge is visible.
  void mark(SurfaceSamples& on) const;
  // Adds the known light to the pixels of the points, with the visibility that `rays` tell.
  void add(const RayLanes& rays, GridEstimate& out) const;

 private:
  using F = BakedPoints::F;
  static_assert(BakedPoints::kMost == kPointLanes);

  BakedBatch(const BakedPoints& points, const BakedPoints::Light& light, const SurfaceSamples& on,
             const GBuffer& g, float scale, float cell_px);

  const BakedPoints& points_;
  BakedMeans mean_;
  F U_, share_, px2_;  // unoccluded light, share, and squared motion in pixels
  F var_residual_, var_visibility_, step_residual_, step_visibility_;  // steps: of the motion
};

inline BakedBatch::BakedBatch(const BakedPoints& points, const SurfaceSamples& on, const GBuffer& g,
                              float scale, float cell_px)
    : BakedBatch(points, points.light(), on, g, scale, cell_px) {}

inline BakedBatch::BakedBatch(const BakedPoints& points, const BakedPoints::Light& light,
                              const SurfaceSamples& on, const GBuffer& g, float scale, float cell_px)
    : points_(points), mean_(points, light.means, scale) {
  // From a level to the one below: a step is half as many cells there, and a quarter of the variance.
  constexpr float kStepToFine = 0.25f;
  LaneMemory<3> of_points;
  for (int i = 0; i < points.count(); ++i) {
    const auto [x, y, index] = points[i];
    const float mx = g.motion_x.at(x, y), my = g.motion_y.at(x, y);
    of_points.set(i, std::array{on.place(index).unoccluded, on[index].share, mx * mx + my * my});
  }
  U_ = load<kPointLanes>(of_points.values[0]), share_ = load<kPointLanes>(of_points.values[1]);
  px2_ = load<kPointLanes>(of_points.values[2]);
  const auto blend = [&](int k, const F& coarse) { return mean_.blend(light.variances, k, coarse); };
  const float per_scale2 = 1 / (scale * scale);  // exact, as both are powers of two
  var_residual_ = per_scale2 * blend(kVarResidual, mean_.of_coarse);
  var_visibility_ = blend(kVarVisibility, mean_.of_coarse);
  const F cells = points.scale() / cell_px, step = cells * cells * px2_;
  const F to_fine = mean_.of_coarse * kStepToFine;
  step_residual_ = per_scale2 * step * blend(kStepResidual, to_fine);
  step_visibility_ = step * blend(kStepVisibility, to_fine);
}

inline void BakedBatch::mark(SurfaceSamples& on) const {
  forEachLane(mean_.known, [&](int i) { on[points_[i].index].baked = true; });
  if (!points_.anyNearShadow()) return;
  const F variance = points_.shadows();
  const auto [near, visible] = mean_.shadows(U_, variance);
  alignas(64) float wanted[kPointLanes];
  store(variance, wanted);
  forEachLane(near, [&, visible = visible](int i) {
    on[points_[i].index].near_shadow = true;
    on.shadows()[points_[i].index].wanted = visible.has(i) ? wanted[i] : 0;
  });
}

inline void BakedBatch::add(const RayLanes& rays, GridEstimate& out) const {
  F visibility = mean_.visibility, var_visibility = var_visibility_, step_visibility = step_visibility_;
  if (rays.any()) rays.refine(px2_ > 0.f, visibility, var_visibility, step_visibility);
  const F var_i = var_residual_ + U_ * U_ * var_visibility;
  const F var_step = step_residual_ + U_ * U_ * step_visibility;
  LaneMemory<3> estimate;
  store(F(share_ * (mean_.residual + U_ * visibility)), estimate.values[0]);
  store(F(share_ * share_ * var_i), estimate.values[1]);
  store(F(share_ * share_ * min(F(2.f * var_i), var_step)), estimate.values[2]);
  forEachLane(mean_.known, [&](int i) {
    const auto [x, y, index] = points_[i];
    out.i.at(x, y) += estimate.values[0][i];
    out.var_i.at(x, y) += estimate.values[1][i];
    out.var_step.at(x, y) += estimate.values[2][i];
  });
}

}  // namespace saccade
