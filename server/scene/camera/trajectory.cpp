#include "scene/camera/trajectory.h"

#include <algorithm>
#include <iterator>

#include "base/check.h"
#include "scene/camera/pose_spline.h"

namespace saccade {

Trajectory::Trajectory(std::vector<TimedPose> keys, Interpolation interpolation)
    : keys_(std::move(keys)), interpolation_(interpolation) {
  SACCADE_CHECK(!keys_.empty());
  const auto not_later = [](const TimedPose& a, const TimedPose& b) { return a.time >= b.time; };
  SACCADE_CHECK(std::adjacent_find(keys_.begin(), keys_.end(), not_later) == keys_.end());
}

Trajectory Trajectory::periodic(std::vector<TimedPose> keys) {
  Trajectory path(std::move(keys));
  SACCADE_CHECK(path.keys_.front().time == TimeNs{0} && path.keys_.size() > 1);
  SACCADE_CHECK(path.keys_.front().pose == path.keys_.back().pose);
  path.periodic_ = true;
  return path;
}

Trajectory::Trajectory(SinePath path) : sines_(std::move(path)) {
  SACCADE_CHECK(sines_->period > TimeNs{0});
}

Trajectory::Trajectory(SplinePath path) : spline_(std::move(path)) {
  SACCADE_CHECK(spline_->period > TimeNs{0} && !spline_->controls.empty());
}

TimeNs Trajectory::lastTime() const {
  if (spline_) return spline_->period;
  return sines_ ? sines_->period : keys_.back().time;
}

void Trajectory::append(const TimedPose& key) {
  SACCADE_CHECK(!periodic_ && !sines_ && !spline_ && key.time > lastTime());
  keys_.push_back(key);
}

Trajectory Trajectory::mounted(const Pose& T_body_camera) const {
  Trajectory path = *this;
  path.mount_.reset();
  if (T_body_camera != Pose{}) path.mount_ = T_body_camera;
  return path;
}

Pose Trajectory::at(TimeNs t) const {
  return mount_ ? bodyAt(t) * *mount_ : bodyAt(t);
}

Pose Trajectory::bodyAt(TimeNs t) const {
  if (sines_) return sines_->at(t);
  if (spline_) return spline_->at(t);
  const auto [next, s, span_s, stands] = find(t, Side::kAfter);
  if (stands) return keys_[next == 0 ? 0 : next - 1].pose;
  if (interpolation_ == Interpolation::kLinear) return interpolate(keys_[next - 1].pose, keys_[next].pose, s);
  return interpolateCubic(keys_, next, s);
}

Velocity Trajectory::velocityAt(TimeNs t) const {
  const Velocity body = bodyVelocityAt(t);
  if (!mount_) return body;
  const Vec3d lever = rotate(bodyAt(t).rotation, cross(body.angular, mount_->position));
  return {body.linear + lever, rotate(conjugate(mount_->rotation), body.angular)};
}

Velocity Trajectory::bodyVelocityAt(TimeNs t) const {
  if (sines_) return sines_->velocityAt(t);
  if (spline_) return spline_->velocityAt(t);
  const auto [next, s, span_s, stands] = find(t, t == TimeNs(0) ? Side::kAfter : Side::kBefore);
  if (stands) return {};
  if (interpolation_ == Interpolation::kCubic) return cubicVelocity(keys_, next, s);
  return interpolationVelocity(keys_[next - 1].pose, keys_[next].pose, s, span_s);
}

Trajectory::Place Trajectory::find(TimeNs t, Side side) const {
  if (periodic_) {
    const TimeNs period = keys_.back().time;
    t = (t % period + period) % period;
    if (side == Side::kBefore && t == TimeNs(0)) t = period;
  }
  const auto after = std::partition_point(keys_.begin(), keys_.end(), [&](const TimedPose& key) {
    return side == Side::kBefore ? key.time < t : key.time <= t;
  });
  Place place{static_cast<std::size_t>(after - keys_.begin())};
  if (after == keys_.begin() || after == keys_.end()) return place;
  const TimedPose& before = *std::prev(after);
  place.stands = false;
  place.span_s = seconds(after->time - before.time);
  place.s = seconds(t - before.time) / place.span_s;
  return place;
}

}  // namespace saccade
