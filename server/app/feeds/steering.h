// The camera of a stream that its client steers: what it has been told, and the path that it has gone.
#pragma once

#include <deque>
#include <mutex>
#include <optional>
#include <variant>
#include <vector>

#include "scene/camera/image_speed.h"
#include "scene/camera/trajectory.h"

namespace saccade {

// The pose of a frame, as the client gave it; or a velocity in the camera's own axes.
using SteerTarget = std::variant<Pose, Twist>;

// All members may be called from any thread.
class Steering {
 public:
  // `path`: the camera's until the first target. `frames`: the last frame's index. `most_waiting`: each
  // target is for one frame, and so many may wait; 0: a target is for all frames until the next target.
  Steering(Trajectory path, double frame_rate_hz, FrameIndex frames, std::size_t most_waiting);

  // The path at frame 0, with room for all frames.
  Trajectory begin() const;

  // Returns the index of the first frame that has the target. Throws LimitReached where too many wait, and
  // Refusal where no frame is left.
  FrameIndex steer(const SteerTarget& target);

  // The feed's thread, before each frame: whether its pose is known, and then the key of its path.
  bool ready() const;
  TimedPose next();

  // A key for each frame begun, such that a request with these keys goes the same path, bit for bit.
  std::vector<TimedPose> keys() const;
  std::size_t frames() const;  // how many have been begun, frame 0 included

 private:
  Pose nextPose(TimeNs t) const;

  const Trajectory path_;
  const double frame_rate_hz_;
  const FrameIndex frames_;
  const std::size_t most_waiting_;

  mutable std::mutex mutex_;
  std::deque<SteerTarget> waiting_;
  std::optional<SteerTarget> target_;
  std::vector<TimedPose> keys_;  // before rotations become unit length
  Pose last_;                    // of the newest frame
};

}  // namespace saccade
