#include "scene/camera/trajectory.h"

#include <algorithm>

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

Pose Trajectory::at(TimeNs t) const {
  if (periodic_) {
    const TimeNs period = keys_.back().time;
    t = (t % period + period) % period;
  }
  const auto after = std::upper_bound(keys_.begin(), keys_.end(), t,
                                      [](TimeNs time, const TimedPose& key) { return time < key.time; });
  if (after == keys_.begin()) return keys_.front().pose;
  const TimedPose& a = *std::prev(after);
  if (after == keys_.end()) return a.pose;
  const double s = seconds(t - a.time) / seconds(after->time - a.time);
  if (interpolation_ == Interpolation::kLinear) return interpolate(a.pose, after->pose, s);
  return interpolateCubic(keys_, static_cast<std::size_t>(after - keys_.begin()), s);
}

}  // namespace saccade
