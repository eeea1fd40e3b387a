// One path that a client steers, of the camera or of an object: what it has been told, and how it has gone.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "scene/camera/image_speed.h"
#include "scene/camera/trajectory.h"

namespace saccade {

// The pose of a frame, as the client gave it; or a velocity in the axes of what moves.
using SteerTarget = std::variant<Pose, Twist>;

class SteeredPath {
 public:
  // `path`: until the first target. `frames`: the last frame's index.
  SteeredPath(Trajectory path, FrameIndex frames);

  // The path at frame 0, with room for all frames.
  Trajectory begin() const;
  // For the next key and all after it, until another target.
  void setTarget(const SteerTarget& target) { target_ = target; }
  // The key at `t`, later than the last one.
  TimedPose next(TimeNs t);

  // Such that a request with these keys goes the same path, bit for bit.
  const std::vector<TimedPose>& keys() const { return keys_; }

 private:
  Pose poseAt(TimeNs t) const;

  Trajectory path_;
  FrameIndex frames_;
  std::optional<SteerTarget> target_;
  std::vector<TimedPose> keys_;  // before rotations become unit length
  Pose last_;                    // of the newest key
};

}  // namespace saccade
