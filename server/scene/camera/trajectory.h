// Camera paths: T_world_camera as a function of stream time.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/units.h"
#include "scene/camera/pose.h"

namespace saccade {

struct TimedPose {
  TimeNs time;
  Pose pose;
};

enum class Interpolation {
  kLinear,  // along the screw motion of SE(3) from key to key: the velocity jumps at the keys
  kCubic,   // the velocity jumps nowhere between the first key and the last, see pose_spline.h
};

inline constexpr double kMaxDistance = 1e9;  // of a position read from outside, scene units along each axis

// Timed poses and what is between them. Before the first and after the last it holds them.
class Trajectory {
 public:
  // At least one key; times strictly increasing.
  explicit Trajectory(std::vector<TimedPose> keys, Interpolation interpolation = Interpolation::kLinear);
  // Repeats for ever; `period` is the time of the last key, whose pose equals the first.
  static Trajectory periodic(std::vector<TimedPose> keys);

  Pose at(TimeNs t) const;
  TimeNs lastTime() const { return keys_.back().time; }  // of the last key; of a periodic one the period

 private:
  std::vector<TimedPose> keys_;
  Interpolation interpolation_;
  bool periodic_ = false;
};

// CSV text, one pose a line, `#` comments and one header line allowed:
//   TUM   `t x y z qx qy qz qw`   seconds, blanks
//   ESIM  `t,x,y,z,qx,qy,qz,qw`   whole nanoseconds, commas
// Times are made relative to the first. `name` is for error messages. Throws SceneError naming the line:
// wrong number of fields, not a finite number, a position beyond 1e9, times that do not increase, a
// quaternion of length 0 (others are made unit length), no pose at all, more than 1,000,000 poses.
Trajectory parseTrajectory(std::string_view csv, const std::string& name);

}  // namespace saccade
