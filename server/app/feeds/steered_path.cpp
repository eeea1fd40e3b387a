#include "app/feeds/steered_path.h"

#include <algorithm>

#include "scene/camera/screw_step.h"

namespace saccade {
namespace {

// A path by velocities stays where a request may have keys.
Vec3d withinBounds(Vec3d p) {
  const auto clamp = [](double x) { return std::clamp(x, -kMaxDistance, kMaxDistance); };
  return {clamp(p.x), clamp(p.y), clamp(p.z)};
}

// As readKeyframes() makes it of the key.
Pose unitPose(const Pose& key, const Quaternion& prev) {
  return {key.position, unitNear(key.rotation, prev)};
}

}  // namespace

SteeredPath::SteeredPath(Trajectory path, FrameIndex frames) : path_(std::move(path)), frames_(frames) {
  keys_.reserve(frames + 1);
  keys_.push_back({TimeNs{0}, path_.at(TimeNs{0})});
  last_ = unitPose(keys_.front().pose, keys_.front().pose.rotation);
}

Trajectory SteeredPath::begin() const {
  std::vector<TimedPose> keys;
  keys.reserve(frames_ + 1);
  keys.push_back({TimeNs{0}, last_});
  return Trajectory(std::move(keys));
}

TimedPose SteeredPath::next(TimeNs t) {
  keys_.push_back({t, poseAt(t)});
  last_ = unitPose(keys_.back().pose, last_.rotation);
  return {t, last_};
}

Pose SteeredPath::poseAt(TimeNs t) const {
  if (!target_) return path_.at(t);
  if (const Pose* pose = std::get_if<Pose>(&*target_)) return *pose;
  const Twist& velocity = std::get<Twist>(*target_);
  const double dt = seconds(t - keys_.back().time);
  const Pose moved = last_ * screwStep(velocity.angular * dt, velocity.linear * dt);
  return {withinBounds(moved.position), moved.rotation};
}

}  // namespace saccade
