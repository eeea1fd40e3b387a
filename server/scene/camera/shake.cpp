#include "scene/camera/shake.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "base/hash_rng.h"

namespace saccade {
namespace {

constexpr double kMaxScale = 2;  // keeps the swing below half a radian
constexpr double kArm = 0.3;  // scene units from the camera to the elbow: a turn of the arm moves the camera

// Cycles in a period of two seconds. Hand and forearm tremble at about 4 Hz, and pressing a button swings the
// camera at 2 Hz [Japanese Journal of Ergonomics 31 (1995) 399]. Translation is slower than rotation.
constexpr int kMoves[] = {2, 3, 4, 6}, kTurns[] = {4, 7, 10, 13, 19};

double rateOf(int cycles) {
  return 2 * std::numbers::pi * cycles / seconds(kShakePeriod);
}

// One axis, told apart by its key: sines that all have this greatest speed, per second; 0 at the start.
SineSum shakeAxis(std::span<const int> cycles, double speed, std::uint64_t key) {
  SineSum axis;
  for (const int n : cycles) {
    const double phase = 2 * std::numbers::pi * toUnit(hashKey(key, static_cast<std::uint64_t>(n)));
    axis.sines.push_back({speed / rateOf(n), n, phase});
  }
  axis.offset = -axis.at(0);
  return axis;
}

// The speed of each sine of translation, in scene units per second, within the bounds of all three axes.
double moveSpeed(double scale, double nearest) {
  double rates = 0, swings = 0;  // where the sines of one axis add up: per unit of their speed
  for (const int n : kMoves) rates += rateOf(n), swings += 2 / rateOf(n);
  const double reach = kMaxShakeReach * nearest;
  return std::min({std::min(kArm, reach) * scale, kMaxShakeAcceleration / (std::sqrt(3.0) * rates),
                   reach / (std::sqrt(3.0) * swings)});
}

SinePath shakePath(const Pose& start, double nearest, double scale, std::uint64_t seed) {
  SinePath path{start, kShakePeriod, {}};
  for (std::size_t i = 0; i < path.axes.size(); ++i) {
    const std::uint64_t key = 8 * seed + i;
    path.axes[i] = i < 3 ? shakeAxis(kMoves, moveSpeed(scale, nearest), key) : shakeAxis(kTurns, scale, key);
  }
  return path;
}

}  // namespace

SinePath makeShake(const Pose& start, const VisiblePoints& view, double speed, std::uint64_t seed,
                   const Lens& lens) {
  const double nearest = nearestDepth(view);
  // Speed is nearly proportional to the scale, so that a few corrections find it.
  double scale = 0.01;
  for (int i = 0; i < 5; ++i) {
    const double found = medianImageSpeed(view, shakePath(start, nearest, scale, seed), lens);
    scale = std::min(kMaxScale, scale * speed / found);
  }
  return shakePath(start, nearest, scale, seed);
}

}  // namespace saccade
