#include "scene/camera/screw_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/camera/motion.h"

namespace saccade {
namespace {

constexpr double kFullTurn = 2 * std::numbers::pi;
constexpr double kForeverSeconds = 1e9;
constexpr TimeNs kShortestTurn{1'000'000};

TimeNs fromSeconds(double s) {
  return TimeNs{std::llround(s * 1e9)};
}

// From the start to `distance`. Between keys the short way round is taken: so they are a quarter turn apart.
std::vector<TimedPose> sweep(const Screw& screw, const Pose& start, double distance, TimeNs span) {
  const double quarters = screw.rotates() ? std::abs(distance) / (kFullTurn / 4) : 0;
  const int pieces = std::max(1, static_cast<int>(std::ceil(quarters)));
  std::vector<TimedPose> keys{{TimeNs{0}, start}};
  for (int i = 1; i <= pieces; ++i) {
    const double part = static_cast<double>(i) / pieces;
    keys.push_back({TimeNs{std::llround(static_cast<double>(span.count()) * part)},
                    start * screw.after(distance * part)});
  }
  return keys;
}

}  // namespace

Pose Screw::after(double distance) const {
  const Quaternion turned = axisAngle(velocity.angular * distance);
  return {velocity.linear * distance + (pivot - rotate(turned, pivot)), turned};
}

Trajectory thereAndBack(const Screw& screw, const Pose& start, double rate, std::optional<double> turn_s) {
  const double farthest = screw.rotates() ? kMaxTurns * kFullTurn : kMaxDistance;
  const double reach = turn_s ? farthest : screw.usual_reach;
  const double span_s = std::min(turn_s.value_or(seconds(kTurnTime)), reach / std::abs(rate));
  const TimeNs span = std::max(fromSeconds(span_s), kShortestTurn);
  std::vector<TimedPose> keys = sweep(screw, start, rate * span_s, span);
  for (std::size_t i = keys.size() - 1; i-- > 0;) keys.push_back({2 * span - keys[i].time, keys[i].pose});
  return Trajectory::periodic(std::move(keys));
}

Trajectory onAndOn(const Screw& screw, const Pose& start, double rate) {
  const double reach_s = (screw.rotates() ? kFullTurn : kMaxDistance) / std::abs(rate);
  const double span_s = std::min(reach_s, kForeverSeconds);
  std::vector<TimedPose> keys = sweep(screw, start, rate * span_s, fromSeconds(span_s));
  if (!screw.rotates() || span_s < reach_s) return Trajectory(std::move(keys));
  keys.back().pose = start;
  return Trajectory::periodic(std::move(keys));
}

}  // namespace saccade
