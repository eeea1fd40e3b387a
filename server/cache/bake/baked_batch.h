// The light that a bake knows at a few points, in lanes.
#pragma once

#include "cache/bake/baked_blend.h"
#include "cache/bake/baked_points.h"
#include "cache/grid/ray_visibility.h"

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

  const BakedPoints& points_;
  F U_, share_, px2_;  // unoccluded light, share, and squared motion in pixels
  F residual_, visibility_;
  F var_residual_, var_visibility_, step_residual_, step_visibility_;  // steps: of the motion
  LaneSet known_;
};

inline BakedBatch::BakedBatch(const BakedPoints& points, const SurfaceSamples& on, const GBuffer& g,
                              float scale, float cell_px)
    : points_(points) {
  constexpr float kLeastShare = 0.5f;  // of a point's weights, on known vertices of its coarser level
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
  const auto [means, variances] = points.light();
  const auto lanes = [](const Octet& column) { return F(__m256(column)); };
  const F of_fine = 1.f - points.fraction();
  const F fine_known = lanes(means[kKnown]), coarse_known = lanes(means[kOfCoarse + kKnown]);
  const F of_coarse = (1.f - of_fine * fine_known) / coarse_known;  // also what no fine vertex knows
  const auto blend = [&](const auto& columns, int k, const F& of_coarse) {
    return F(lanes(columns[k]) * of_fine + lanes(columns[kOfCoarse + k]) * of_coarse);
  };
  visibility_ = blend(means, kVisibility, of_coarse);
  residual_ = blend(means, kResidual, of_coarse) / scale;
  const float per_scale2 = 1 / (scale * scale);  // exact, as both are powers of two
  var_residual_ = per_scale2 * blend(variances, kVarResidual, of_coarse);
  var_visibility_ = blend(variances, kVarVisibility, of_coarse);
  const F cells = points.scale() / cell_px, step = cells * cells * px2_, to_fine = of_coarse * kStepToFine;
  step_residual_ = per_scale2 * step * blend(variances, kStepResidual, to_fine);
  step_visibility_ = step * blend(variances, kStepVisibility, to_fine);
  known_ = lanesOf(coarse_known >= kLeastShare) & LaneSet::first(points.count());
}

inline void BakedBatch::mark(SurfaceSamples& on) const {
  forEachLane(known_, [&](int i) { on[points_[i].index].baked = true; });
  if (!points_.anyNearShadow()) return;
  const F variance = points_.shadows();
  const F least = kLeastShadowContrast * (residual_ + U_ * visibility_);
  const auto reaches = [&](float share) {
    return variance > kLeastShadow && U_ * U_ * variance > share * share * least * least;
  };
  const LaneSet visible = lanesOf(reaches(1)) & known_;
  alignas(64) float wanted[kPointLanes];
  store(variance, wanted);
  forEachLane(lanesOf(reaches(kLeastNearShadow)) & known_, [&](int i) {
    on[points_[i].index].near_shadow = true;
    on.shadows()[points_[i].index].wanted = visible.has(i) ? wanted[i] : 0;
  });
}

inline void BakedBatch::add(const RayLanes& rays, GridEstimate& out) const {
  F visibility = visibility_, var_visibility = var_visibility_, step_visibility = step_visibility_;
  if (rays.any()) rays.refine(px2_ > 0.f, visibility, var_visibility, step_visibility);
  const F var_i = var_residual_ + U_ * U_ * var_visibility;
  const F var_step = step_residual_ + U_ * U_ * step_visibility;
  LaneMemory<3> estimate;
  store(F(share_ * (residual_ + U_ * visibility)), estimate.values[0]);
  store(F(share_ * share_ * var_i), estimate.values[1]);
  store(F(share_ * share_ * min(F(2.f * var_i), var_step)), estimate.values[2]);
  forEachLane(known_, [&](int i) {
    const auto [x, y, index] = points_[i];
    out.i.at(x, y) += estimate.values[0][i];
    out.var_i.at(x, y) += estimate.values[1][i];
    out.var_step.at(x, y) += estimate.values[2][i];
  });
}

}  // namespace saccade
