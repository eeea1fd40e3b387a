// Camera paths: T_world_camera as a function of stream time.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/units.h"
#include "scene/camera/pose.h"
#include "scene/camera/sine_path.h"
#include "scene/camera/spline_path.h"

namespace saccade {

struct TimedPose {
  TimeNs time;
  Pose pose;
};

enum class Interpolation {
  kLinear,  // along the screw motion of SE(3) from key to key: the velocity jumps at the keys
  kCubic,   // with a continuous velocity between the first key and the last, see pose_spline.h
};

inline constexpr double kMaxDistance = 1e9;  // limit of a position along each axis, scene units

// A camera path through timed poses. It stands still before the first and after the last.
class Trajectory {
 public:
  // `keys`: at least one, with strictly increasing times.
  explicit Trajectory(std::vector<TimedPose> keys, Interpolation interpolation = Interpolation::kLinear);
  // Repeats for ever with the time of the last key as period. The first key is at 0; the last has its pose.
  static Trajectory periodic(std::vector<TimedPose> keys);
  explicit Trajectory(SinePath path);  // repeats for ever, too
  explicit Trajectory(SplinePath path);

  // Adds a key after the last one. Not to a path that repeats.
  void append(const TimedPose& key);
  // The path of a camera that is fixed to a body on this one. Where T_body_camera is the identity, it has the
  // same bits.
  Trajectory mounted(const Pose& T_body_camera) const;

  Pose at(TimeNs t) const;      // T_world_camera
  Pose bodyAt(TimeNs t) const;  // T_world_body: without the last mounted()
  // The derivatives of both, in closed form. Where they jump, they are those just before t; at 0, just after.
  Velocity velocityAt(TimeNs t) const;
  Velocity bodyVelocityAt(TimeNs t) const;
  // For a path that repeats: the period.
  TimeNs lastTime() const;

 private:
  // Between keys[next - 1] and keys[next], of which one may be missing.
  struct Place {
    std::size_t next;
    double s = 0, span_s = 0;
    bool stands = true;  // before the first key or after the last
  };
  enum class Side { kBefore, kAfter };
  Place find(TimeNs t, Side side) const;  // the segment just before or just after t

  std::optional<SinePath> sines_;     // instead of keys
  std::optional<SplinePath> spline_;  // likewise
  std::vector<TimedPose> keys_;
  Interpolation interpolation_ = Interpolation::kLinear;
  bool periodic_ = false;
  std::optional<Pose> mount_;  // T_body_camera, unless it is the identity
};

// Reads text with one pose a line. A heading names the columns, see pose_columns.h. Without one:
//   TUM   `t x y z qx qy qz qw`   seconds, blanks
//   ESIM  `t,x,y,z,qx,qy,qz,qw`   whole nanoseconds, commas
// A heading that names no unit of time has these units too. Other lines that begin with `#` are remarks.
// Times become relative to the first; quaternions become unit length. `name` is the file's, for errors;
// empty: errors name the line alone. Throws SceneError at an unknown heading, a wrong number of fields, a
// number that is not finite, or a position beyond 1e9. The same holds for times that do not increase, a
// quaternion of length 0, and for less than 1 or more than 1,000,000 poses.
struct PoseText {
  std::vector<TimedPose> poses;
  TimeNs begin;  // the time of the first pose in the text
};
PoseText readPoses(std::string_view csv, const std::string& name);
Trajectory parseTrajectory(std::string_view csv, const std::string& name);  // of these poses

}  // namespace saccade
