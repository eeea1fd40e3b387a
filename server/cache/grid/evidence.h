// Evidence of a pixel's own samples for the detail that each level claims [ours].
//
// Let c be the estimate of the coarser levels and d the detail of a level, both without the sample i itself.
// Then x = (i - c) d has the mean of d times the true detail: the sample knows nothing of the noise of d. Its
// sum is an estimate of the energy of the detail without bias, and the sum of x^2 bounds the noise of that.
#pragma once

#include "cache/grid/point_lanes.h"

namespace saccade {

struct Evidence {
  std::array<float, kTop> residual{}, visibility{};        // x, by the slot of the detail
  float deviation_residual = 0, deviation_visibility = 0;  // of the whole estimate
  float weight = 0, unoccluded = 0;                        // of the samples
  Octet ofSlot(int k) const {                              // as GridLevel::evidence adds it up
    const auto square = [](float v) { return v * v; };
    return Octet{residual[k],   square(residual[k]),   square(deviation_residual),   weight,
                 visibility[k], square(visibility[k]), square(deviation_visibility), unoccluded};
  }
};

// Writes the evidence of a few points to their places in `out`. `samples`: by point, what each has added to
// the grid, as GridLevel::light adds it up.
inline void findEvidence(const LevelBlend<PointFloats>& blend, const PointLanes& lanes,
                         const std::vector<Quad>& samples, const Placement& at, std::vector<Evidence>& out) {
  using F = PointFloats;
  constexpr float kLeastSamples = 1e-3f;
  LaneMemory<4> sample_lanes;
  LaneMemory<kGridLevels> own_lanes;
  for (int i = 0; i < lanes.count; ++i) {
    sample_lanes.set(i, samples[lanes.points[i]]);
    for (int k = 0; k <= kTop; ++k) own_lanes.values[k][i] = at.ownShare(at.points[lanes.points[i]], k);
  }
  const auto sample = sample_lanes.lanes();
  const auto own = own_lanes.lanes();
  LaneMemory<2 * kTop + 2> found;
  F residual = 0.f, visibility = 1.f;  // the estimate without the samples, by the levels so far
  for (int k = kTop; k >= 0; --k) {
    const auto others = [&](int part) { return blend.light[k][part] - sample[part] * own[k]; };
    const F level_residual = select(others(0) > kLeastSamples, others(1) / others(0), residual);
    const F level_visibility = select(others(3) > kLeastSamples, others(2) / others(3), visibility);
    if (k == kTop) {
      residual = level_residual, visibility = level_visibility;
      continue;
    }
    store(F((sample[1] - residual * sample[0]) * (level_residual - residual)), found.values[k]);
    store(F((sample[2] - visibility * sample[3]) * (level_visibility - visibility)), found.values[kTop + k]);
    residual += blend.residual.alpha[k] * (level_residual - residual);
    visibility += blend.visibility.alpha[k] * (level_visibility - visibility);
  }
  store(F(sample[1] - residual * sample[0]), found.values[2 * kTop]);
  store(F(sample[2] - visibility * sample[3]), found.values[2 * kTop + 1]);
  for (int i = 0; i < lanes.count; ++i) {
    const Quad& s = samples[lanes.points[i]];
    Evidence& e = out[lanes.points[i]];
    for (int k = 0; k < kTop; ++k)
      e.residual[k] = found.values[k][i], e.visibility[k] = found.values[kTop + k][i];
    e.deviation_residual = found.values[2 * kTop][i], e.deviation_visibility = found.values[2 * kTop + 1][i];
    e.weight = s[0], e.unoccluded = s[3];
  }
}

}  // namespace saccade
