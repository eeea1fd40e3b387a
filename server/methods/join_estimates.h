// Joins two estimates of the same planes, as far as both agree [ours].
#pragma once

#include <chrono>

#include "base/pool_handle.h"
#include "frame/image.h"

namespace saccade {

struct EstimatedPlane {
  const ImageF &value, &variance;
};

inline constexpr float kNoEstimate = -1;  // instead of a variance

// `joined` = own + w (other - own),   w = var / (var + var_other + b^2).
// b^2 is by how much both differ in the 5x5 pixels around one, beyond their noise. Where there is no other
// estimate, it is `own`. The planes of `joined` must differ from those of both.
std::chrono::nanoseconds joinEstimates(EstimatedPlane own, EstimatedPlane other, const PoolHandle& pool,
                                       ImageF& joined, ImageF& variance);

}  // namespace saccade
