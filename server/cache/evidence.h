// What a pixel's own samples say of the detail that each level claims [ours].
//
// With c what the coarser levels say and d the detail of a level, both without the sample i itself, x = (i -
// c) d has the mean of d times what is truly there: the sample knows nothing of the noise of d. Its sum is an
// estimate of the energy of the detail without bias, and the sum of x^2 bounds the noise of that.
#pragma once

#include "cache/level_blend.h"

namespace saccade {

struct Evidence {
  std::array<float, kTop> rest{}, visibility{};      // x, by the slot of the detail
  float residual_rest = 0, residual_visibility = 0;  // of the whole estimate
  float weight = 0, unoccluded = 0;                  // of the samples
  Octet ofSlot(int k) const {                        // as GridLevel::evidence adds it up
    const auto square = [](float v) { return v * v; };
    return Octet{rest[k],       square(rest[k]),       square(residual_rest),       weight,
                 visibility[k], square(visibility[k]), square(residual_visibility), unoccluded};
  }
};

// `sample`: what the pixel has added to the grid, as GridLevel::light adds it up.
inline Evidence evidenceOf(const LevelBlend& blend, const Quad& sample, const Placement& at,
                           const GridPoint& p) {
  constexpr float kLeastSamples = 1e-3f;
  Evidence e;
  float rest = 0, visibility = 1;  // what all others say so far
  for (int k = kTop; k >= 0; --k) {
    const Quad others = blend.light[k] - sample * at.ownShare(p, k);
    const float level_rest = others[0] > kLeastSamples ? others[1] / others[0] : rest;
    const float level_visibility = others[3] > kLeastSamples ? others[2] / others[3] : visibility;
    if (k == kTop) {
      rest = level_rest, visibility = level_visibility;
      continue;
    }
    e.rest[k] = (sample[1] - rest * sample[0]) * (level_rest - rest);
    e.visibility[k] = (sample[2] - visibility * sample[3]) * (level_visibility - visibility);
    rest += blend.rest.alpha[k] * (level_rest - rest);
    visibility += blend.visibility.alpha[k] * (level_visibility - visibility);
  }
  e.residual_rest = sample[1] - rest * sample[0];
  e.residual_visibility = sample[2] - visibility * sample[3];
  e.weight = sample[0], e.unoccluded = sample[3];
  return e;
}

}  // namespace saccade
