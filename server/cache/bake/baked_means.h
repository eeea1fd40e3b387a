// The light that a bake knows at a few points, in lanes, without its variance.
#pragma once

#include "cache/bake/baked_blend.h"
#include "cache/bake/baked_points.h"
#include "cache/grid/ray_visibility.h"

namespace saccade {

struct BakedMeans {
  using F = BakedPoints::F;
  // Columns of BakedSums.
  static F lanes(const Octet& column) { return F(__m256(column)); }

  // `scale`: of the residual that vertices keep.
  BakedMeans(const BakedPoints& points, const std::array<Octet, BakedPoints::kMost>& means, float scale)
      : of_fine(1.f - points.fraction()),
        of_coarse((1.f - of_fine * lanes(means[kKnown])) / lanes(means[kOfCoarse + kKnown])),
        residual(blend(means, kResidual, of_coarse) / scale),
        visibility(blend(means, kVisibility, of_coarse)),
        known(lanesOf(lanes(means[kOfCoarse + kKnown]) >= kLeastShare) & LaneSet::first(points.count())) {}

  F blend(const auto& columns, int k, const F& coarse) const {
    return F(lanes(columns[k]) * of_fine + lanes(columns[kOfCoarse + k]) * coarse);
  }

  // Where a variance of visibility makes rays worth their cost: at the edge of a shadow that is visible, and
  // around it. `U`: unoccluded light.
  struct Shadows {
    LaneSet near, visible;
  };
  Shadows shadows(const F& U, const F& variance) const {
    const F least = kLeastShadowContrast * (residual + U * visibility);
    const auto reaches = [&](float share) {
      return lanesOf(variance > kLeastShadow && U * U * variance > share * share * least * least) & known;
    };
    return {reaches(kLeastNearShadow), reaches(1)};
  }

  F of_fine, of_coarse;  // weights; the latter also of what no fine vertex knows
  F residual, visibility;
  LaneSet known;

 private:
  static constexpr float kLeastShare = 0.5f;  // of a point's weights, on known vertices of its coarser level
};

}  // namespace saccade
