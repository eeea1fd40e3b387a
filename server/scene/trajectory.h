// Camera paths: T_world_camera as a function of stream time.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/units.h"
#include "scene/pose.h"

namespace saccade {

struct TimedPose {
  TimeNs time;
  Pose pose;
};

// Timed poses, interpolated on SE(3). Before the first and after the last it holds them.
class Trajectory {
 public:
  explicit Trajectory(std::vector<TimedPose> keys);  // at least one; times strictly increasing
  // Repeats for ever; `period` is the time of the last key, whose pose equals the first.
  static Trajectory periodic(std::vector<TimedPose> keys);

  Pose at(TimeNs t) const;

 private:
  std::vector<TimedPose> keys_;
  bool periodic_ = false;
};

// CSV text, one pose a line, `#` comments and one header line allowed:
//   TUM   `t x y z qx qy qz qw`   seconds, blanks
//   ESIM  `t,x,y,z,qx,qy,qz,qw`   whole nanoseconds, commas
// Times are made relative to the first. `name` is for error messages. Throws SceneError naming the line:
// wrong number of fields, not a finite number, a position beyond 1e9, times that do not increase, a
// quaternion of length 0 (others are made unit length), no pose at all, more than 1,000,000 poses.
Trajectory parseTrajectory(std::string_view csv, const std::string& name);

// The motions that exist for any scene.
//   right    to the camera's right         forward  along the viewing axis      still  none
//   orbit    around the point looked at    shake    hand-held: a sum of seeded sines in all six axes
// Speeds are chosen by what the camera sees: `probes` are world-space points on the surfaces in view. The
// median speed of their images is kMotionPxPerFrame in a picture kMotionWidth pixels wide at kMotionRateHz:
// at the start, and for shake over its period. Probes behind the camera do not count; without any, one is
// assumed on the viewing axis at distance 1. A motion that would move none of them stands still; shake has a
// largest swing, which makes it slower where the field of view is beyond about 120 degrees. right, forward
// and orbit turn back after kTurnTime (forward sooner, when it has gone a quarter of the way to the nearest
// probe; orbit sooner, when it has turned by kMaxOrbitRad), and so stay in the scene for ever.
inline constexpr double kMotionPxPerFrame = 0.67, kMotionWidth = 256, kMotionRateHz = 500;
inline constexpr TimeNs kTurnTime{200'000'000}, kShakePeriod{2'000'000'000};
inline constexpr double kMaxOrbitRad = 0.25;
const std::vector<std::string>& motionNames();
bool isMotion(const std::string& name);
Trajectory makeMotion(const std::string& name, const Pose& start, const std::vector<Vec3>& probes,
                      double fov_x_deg);

}  // namespace saccade
