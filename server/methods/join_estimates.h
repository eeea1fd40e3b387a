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

// `joined` = own + w (other - own),   w = var / (var + var_other + b^2)
//
// where b^2 is the square of what both differ by, beyond their noise, in the mean of 5x5 pixels. Where there
// is no other estimate, `joined` is `own`. Its planes must differ from those of both.
std::chrono::nanoseconds joinEstimates(EstimatedPlane own, EstimatedPlane other, const PoolHandle& pool,
                                       ImageF& joined, ImageF& variance);

}  // namespace saccade
