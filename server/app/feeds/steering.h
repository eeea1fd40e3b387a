// The camera and the objects of a stream that its client steers.
#pragma once

#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <vector>

#include "app/feeds/steered_path.h"
#include "feed/feed_keys.h"

namespace saccade {

// Targets that a client gives at once. Others go on as before.
struct SteerTargets {
  std::optional<SteerTarget> camera = {};
  std::map<std::size_t, Pose> bodies = {};  // by their numbers
};

// All members may be called from any thread.
class Steering {
 public:
  // `camera`, `bodies`: the paths until the first target; bodies that are not among these cannot be steered.
  // `frames`: the last frame's index. `most_waiting`: all targets told at once are for one frame, and so many
  // may wait; 0: they are for all frames until the next ones.
  Steering(Trajectory camera, std::map<std::size_t, Trajectory> bodies, double frame_rate_hz,
           FrameIndex frames, std::size_t most_waiting);

  // The paths at frame 0, with room for all frames.
  Trajectory begin() const { return camera_.begin(); }
  std::map<std::size_t, Trajectory> bodiesBegin() const;

  bool steers(std::size_t body) const { return bodies_.contains(body); }

  // Returns the index of the first frame that has the targets. Throws LimitReached where too many wait, and
  // Refusal where no frame is left.
  FrameIndex steer(const SteerTargets& targets);

  // The feed's thread, before each frame: whether its poses are known, and then the keys of the paths.
  bool ready() const;
  FeedKeys next();

  // A key for each frame begun, such that a request with these keys goes the same path, bit for bit.
  std::vector<TimedPose> keys() const;
  std::map<std::size_t, std::vector<TimedPose>> bodyKeys() const;
  std::size_t frames() const;  // how many have been begun, frame 0 included
  std::size_t paths() const { return 1 + bodies_.size(); }

 private:
  void merge(const SteerTargets& targets);

  const double frame_rate_hz_;
  const FrameIndex frames_;
  const std::size_t most_waiting_;

  mutable std::mutex mutex_;
  std::deque<SteerTargets> waiting_;
  SteeredPath camera_;
  std::map<std::size_t, SteeredPath> bodies_;
};

}  // namespace saccade
