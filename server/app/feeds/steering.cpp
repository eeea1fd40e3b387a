#include "app/feeds/steering.h"

#include "app/admission/limits.h"

namespace saccade {
namespace {

constexpr double kSteerRetrySeconds = 0.1;

}  // namespace

Steering::Steering(Trajectory camera, std::map<std::size_t, Trajectory> bodies, double frame_rate_hz,
                   FrameIndex frames, std::size_t most_waiting)
    : frame_rate_hz_(frame_rate_hz),
      frames_(frames),
      most_waiting_(most_waiting),
      camera_(std::move(camera), frames) {
  for (auto& [body, path] : bodies) bodies_.emplace(body, SteeredPath(std::move(path), frames));
}

std::map<std::size_t, Trajectory> Steering::bodiesBegin() const {
  std::map<std::size_t, Trajectory> paths;
  for (const auto& [body, path] : bodies_) paths.emplace(body, path.begin());
  return paths;
}

FrameIndex Steering::steer(const SteerTargets& targets) {
  std::lock_guard lock(mutex_);
  const std::size_t ahead = most_waiting_ == 0 ? 0 : waiting_.size();
  const FrameIndex frame = camera_.keys().size() + ahead;
  if (frame > frames_) throw Refusal(v1::CODE_NOT_FOUND, "stream_id", "no frame of the stream is left");
  if (most_waiting_ > 0 && ahead >= most_waiting_) {
    throw LimitReached(Limit::kSteers, {}, std::to_string(most_waiting_) + " wait for their frames",
                       kSteerRetrySeconds);
  }
  if (most_waiting_ > 0 || waiting_.empty())
    waiting_.push_back(targets);
  else
    merge(targets);
  return frame;
}

// Into those that wait for the next frame: the newest target of each path counts.
void Steering::merge(const SteerTargets& targets) {
  SteerTargets& next = waiting_.back();
  if (targets.camera) next.camera = targets.camera;
  for (const auto& [body, pose] : targets.bodies) next.bodies.insert_or_assign(body, pose);
}

bool Steering::ready() const {
  std::lock_guard lock(mutex_);
  return most_waiting_ == 0 || !waiting_.empty();
}

FeedKeys Steering::next() {
  std::lock_guard lock(mutex_);
  if (!waiting_.empty()) {
    const SteerTargets& targets = waiting_.front();
    if (targets.camera) camera_.setTarget(*targets.camera);
    for (const auto& [body, pose] : targets.bodies) bodies_.at(body).setTarget(pose);
    waiting_.pop_front();
  }
  const TimeNs t = frameTime(camera_.keys().size(), frame_rate_hz_);
  FeedKeys keys{camera_.next(t)};
  for (auto& [body, path] : bodies_) keys.bodies.push_back({body, path.next(t)});
  return keys;
}

std::vector<TimedPose> Steering::keys() const {
  std::lock_guard lock(mutex_);
  return camera_.keys();
}

std::map<std::size_t, std::vector<TimedPose>> Steering::bodyKeys() const {
  std::lock_guard lock(mutex_);
  std::map<std::size_t, std::vector<TimedPose>> keys;
  for (const auto& [body, path] : bodies_) keys.emplace(body, path.keys());
  return keys;
}

std::size_t Steering::frames() const {
  std::lock_guard lock(mutex_);
  return camera_.keys().size();
}

}  // namespace saccade
