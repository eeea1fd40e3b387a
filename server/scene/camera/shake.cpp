#include "scene/camera/shake.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/hash_rng.h"

namespace saccade {
namespace {

constexpr TimeNs kStep{1'000'000};
constexpr double kTravel = 0.25;  // a hand turns more than it travels: weight of translation in the picture
constexpr double kMaxScale = 2;   // keeps the swing below half a radian

// One axis, told apart by its key: sines of these many cycles in a period, all of the same speed; 0 at the
// start.
double shakeAt(std::uint64_t key, double t) {
  double sum = 0;
  for (const int cycles : {4, 7, 10, 13, 19}) {
    const double rate = 2 * std::numbers::pi * cycles / seconds(kShakePeriod);
    const double phase = 2 * std::numbers::pi * toUnit(hashKey(key, static_cast<std::uint64_t>(cycles)));
    sum += (std::sin(rate * t + phase) - std::sin(phase)) / rate;
  }
  return sum;
}

// Poses relative to the start, for a picture whose surfaces are `depth` away.
std::vector<Pose> shakePoses(double depth, double scale, std::uint64_t seed) {
  std::vector<Pose> poses;
  for (TimeNs time{0}; time < kShakePeriod; time += kStep) {
    const auto at = [&](std::uint64_t axis) { return scale * shakeAt(8 * seed + axis, seconds(time)); };
    poses.push_back({Vec3d{at(0), at(1), at(2)} * (kTravel * depth), axisAngle({at(3), at(4), at(5)})});
  }
  return poses;
}

}  // namespace

Trajectory makeShake(const Pose& start, const VisiblePoints& view, double speed, std::uint64_t seed,
                     const Lens& lens) {
  const double depth = medianDepth(view);
  // Speed is nearly proportional to the scale, so that a few corrections find it.
  double scale = 0.01;
  for (int i = 0; i < 5; ++i) {
    const double found = medianImageSpeed(view, shakePoses(depth, scale, seed), seconds(kStep), lens);
    scale = std::min(kMaxScale, scale * speed / found);
  }
  std::vector<TimedPose> keys;
  for (const Pose& pose : shakePoses(depth, scale, seed))
    keys.push_back({std::ssize(keys) * kStep, start * pose});
  keys.push_back({kShakePeriod, keys.front().pose});
  return Trajectory::periodic(std::move(keys));
}

}  // namespace saccade
