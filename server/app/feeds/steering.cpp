#include "app/feeds/steering.h"

#include <algorithm>

#include "app/admission/limits.h"
#include "scene/camera/screw_step.h"

namespace saccade {
namespace {

constexpr double kSteerRetrySeconds = 0.1;

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

Steering::Steering(Trajectory path, double frame_rate_hz, FrameIndex frames, std::size_t most_waiting)
    : path_(std::move(path)), frame_rate_hz_(frame_rate_hz), frames_(frames), most_waiting_(most_waiting) {
  keys_.reserve(frames + 1);
  keys_.push_back({TimeNs{0}, path_.at(TimeNs{0})});
  last_ = unitPose(keys_.front().pose, keys_.front().pose.rotation);
}

Trajectory Steering::begin() const {
  std::vector<TimedPose> keys;
  keys.reserve(frames_ + 1);
  keys.push_back({TimeNs{0}, last_});
  return Trajectory(std::move(keys));
}

FrameIndex Steering::steer(const SteerTarget& target) {
  std::lock_guard lock(mutex_);
  if (most_waiting_ == 0) waiting_.clear();
  const FrameIndex frame = keys_.size() + waiting_.size();
  if (frame > frames_) throw Refusal(v1::CODE_NOT_FOUND, "stream_id", "no frame of the stream is left");
  if (most_waiting_ > 0 && waiting_.size() >= most_waiting_) {
    throw LimitReached(Limit::kSteers, {}, std::to_string(most_waiting_) + " wait for their frames",
                       kSteerRetrySeconds);
  }
  waiting_.push_back(target);
  return frame;
}

bool Steering::ready() const {
  std::lock_guard lock(mutex_);
  return most_waiting_ == 0 || !waiting_.empty();
}

TimedPose Steering::next() {
  std::lock_guard lock(mutex_);
  if (!waiting_.empty()) {
    target_ = waiting_.front();
    waiting_.pop_front();
  }
  const TimeNs t = frameTime(keys_.size(), frame_rate_hz_);
  keys_.push_back({t, nextPose(t)});
  last_ = unitPose(keys_.back().pose, last_.rotation);
  return {t, last_};
}

Pose Steering::nextPose(TimeNs t) const {
  if (!target_) return path_.at(t);
  if (const Pose* pose = std::get_if<Pose>(&*target_)) return *pose;
  const Twist& velocity = std::get<Twist>(*target_);
  const double dt = seconds(t - keys_.back().time);
  const Pose moved = last_ * screwStep(velocity.angular * dt, velocity.linear * dt);
  return {withinBounds(moved.position), moved.rotation};
}

std::vector<TimedPose> Steering::keys() const {
  std::lock_guard lock(mutex_);
  return keys_;
}

std::size_t Steering::frames() const {
  std::lock_guard lock(mutex_);
  return keys_.size();
}

}  // namespace saccade
