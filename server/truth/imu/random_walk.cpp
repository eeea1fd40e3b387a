#include "truth/imu/random_walk.h"

#include <cmath>
#include <numbers>

#include "base/check.h"
#include "base/hash_rng.h"

namespace saccade {
namespace {

constexpr std::uint64_t kSteps = std::uint64_t{1} << 40;

// In (0, 1).
double unitAt(std::uint64_t key) {
  return (static_cast<double>(key >> 11) + 0.5) * 0x1p-53;
}

}  // namespace

// [Box, Muller 1958].
double normalAt(std::uint64_t key) {
  const double radius = std::sqrt(-2 * std::log(unitAt(hashKey(key, 0))));
  return radius * std::cos(2 * std::numbers::pi * unitAt(hashKey(key, 1)));
}

RandomWalk::RandomWalk(std::uint64_t key)
    : key_(key),
      path_{{0, kSteps, 1, 0, std::sqrt(static_cast<double>(kSteps)) * normalAt(hashKey(key, 0))}} {}

double RandomWalk::at(std::uint64_t step) {
  SACCADE_CHECK(step < kSteps);
  while (!path_.back().holds(step)) path_.pop_back();
  while (path_.back().begin != step) path_.push_back(halfOf(path_.back(), step));
  return path_.back().left;
}

// Between two known values an interval apart, the middle is normal about their mean, with variance
// interval / 4.
RandomWalk::Interval RandomWalk::halfOf(const Interval& whole, std::uint64_t step) const {
  const double spread = std::sqrt(static_cast<double>(whole.span)) / 2;
  const double middle = (whole.left + whole.right) / 2 + spread * normalAt(hashKey(key_, whole.number));
  const std::uint64_t half = whole.span / 2;
  if (step < whole.begin + half) return {whole.begin, half, 2 * whole.number, whole.left, middle};
  return {whole.begin + half, half, 2 * whole.number + 1, middle, whole.right};
}

}  // namespace saccade
