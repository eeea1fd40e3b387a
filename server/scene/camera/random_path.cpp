#include "scene/camera/random_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/hash_rng.h"

namespace saccade {
namespace {

constexpr int kSines = 3;

// Amplitudes that add up to `bound`. The faster a sine, the smaller it is.
SineSum wander(double bound, std::uint64_t key) {
  const auto draw = [&](std::uint64_t n) -> double { return toUnit(hashKey(key, n)); };
  SineSum sum;
  double total = 0;
  for (int n = 1; n <= kSines; ++n) {
    const auto address = static_cast<std::uint64_t>(2 * n);
    sum.sines.push_back({(0.5 + draw(address)) / n, n, 2 * std::numbers::pi * draw(address + 1)});
    total += sum.sines.back().amplitude;
  }
  for (SineSum::Sine& sine : sum.sines) sine.amplitude *= bound / total;
  return sum;
}

}  // namespace

SinePath makeRandomPath(const Pose& middle, const VisiblePoints& view, double speed, std::uint64_t seed,
                        const Lens& lens) {
  const double reach = kMaxRandomReach * nearestDepth(view) / std::sqrt(3.0);  // along each axis
  const double bounds[] = {reach, reach, reach, kMaxRandomPan, kMaxRandomTilt, kMaxRandomRoll};
  constexpr TimeNs kSecond{1'000'000'000};
  SinePath path{middle, kSecond, {}};
  for (std::size_t i = 0; i < path.axes.size(); ++i) path.axes[i] = wander(bounds[i], hashKey(seed, i));
  const double period_s = std::clamp(medianImageSpeed(view, path, lens) / speed, seconds(kMinRandomPeriod),
                                     seconds(kMaxRandomPeriod));
  path.period = TimeNs{std::llround(period_s * 1e9)};
  return path;
}

}  // namespace saccade
