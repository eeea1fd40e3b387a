#include "methods/join_estimates.h"

#include <algorithm>

#include "methods/pixels_around.h"

namespace saccade {
namespace {

constexpr int kAround = 2;               // pixels on each side, in which two estimates are compared
constexpr float kLeastVariance = 0.05f;  // of what is joined, relative to that of its own estimate

// The square of what both differ by beyond their noise, in the mean around a pixel.
float squareApart(EstimatedPlane own, EstimatedPlane other, int x, int y) {
  float sum = 0, n = 0;
  forEachAround(own.value, x, y, kAround, [&](int u, int v) {
    const float var_other = other.variance.at(u, v);
    if (var_other == kNoEstimate) return;
    const float apart = own.value.at(u, v) - other.value.at(u, v);
    sum += apart * apart - own.variance.at(u, v) - var_other, n += 1;
  });
  return std::max(sum / n, 0.f);
}

}  // namespace

std::chrono::nanoseconds joinEstimates(EstimatedPlane own, EstimatedPlane other, const PoolHandle& pool,
                                       ImageF& joined, ImageF& variance) {
  return pool.forEachRow(joined.height(), [&](int y) {
    for (int x = 0; x < joined.width(); ++x) {
      const float value = own.value.at(x, y), var = own.variance.at(x, y);
      const float var_other = other.variance.at(x, y);
      joined.at(x, y) = value, variance.at(x, y) = var;
      if (var_other == kNoEstimate) continue;
      const float all = var + var_other + squareApart(own, other, x, y);
      const float w = all > 0 ? var / all : 0;
      joined.at(x, y) = value + w * (other.value.at(x, y) - value);
      variance.at(x, y) = std::max((1 - w) * (1 - w) * var + w * w * var_other, kLeastVariance * var);
    }
  });
}

}  // namespace saccade
