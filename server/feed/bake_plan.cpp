#include "feed/bake_plan.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/content_hash.h"
#include "scene/emitter_strengths.h"

namespace saccade {
namespace {

constexpr std::uint32_t kVersion = 9;      // of what a plan leads to: the code's part in the digest
constexpr double kPixelsBetweenPoses = 4;  // at most, of the fastest percent of the picture
constexpr double kPoseRate = 1000;         // Hz: poses of frames with several intervals come from these times

}  // namespace

BakePlan planBake(const RenderScene& scene, const Trajectory& path, const FeedConfig& asked,
                  FrameIndex frames, double error) {
  FeedConfig feed = asked;
  if (asked.intervals.followMotion()) {
    feed.frame_rate_hz = std::max(asked.frame_rate_hz, kPoseRate);
    frames = static_cast<FrameIndex>(
        std::ceil(static_cast<double>(frames) * (feed.frame_rate_hz / asked.frame_rate_hz)));
  }
  if (!EmitterStrengths(scene.description()).areSteady())
    throw std::runtime_error(
        "the light of this scene changes over time, so that it cannot be computed ahead; leave out the bake");
  if (!feed.body_paths.empty())
    throw std::runtime_error(
        "light is computed ahead for objects that stand; let none move, or leave out the bake");
  frames = framesToLookAt(path, feed.frame_rate_hz, frames);
  const double speed = measurePixelSpeed(scene, path, feed, frames).p99;
  const auto step = std::max(
      FrameIndex{1}, static_cast<FrameIndex>(std::min(kPixelsBetweenPoses / std::max(speed, 1e-9), 1e9)));
  BakePlan plan{.camera = feed.camera,
                .bounces = feed.bounces,
                .channels = feed.monochrome ? 1 : scene.channels(),
                .error = static_cast<float>(error)};
  const auto add = [&](FrameIndex t) { plan.poses.push_back(path.at(frameTime(t, feed.frame_rate_hz))); };
  for (FrameIndex t = 0; t < frames; t += step) add(t);
  add(frames);
  return plan;
}

std::uint64_t digestOf(const RenderScene& scene, const BakePlan& plan) {
  ContentHash h;
  h.add(kVersion), h.add(scene.digest());
  for (const Pose& pose : plan.poses) h.add(pose.position), h.add(pose.rotation);
  const CameraModel& camera = plan.camera;
  h.add(camera.width), h.add(camera.height), h.add(camera.fx), h.add(camera.fy), h.add(camera.cx);
  h.add(camera.cy), h.add(camera.distortion.model), h.add(camera.distortion.k);
  h.add(plan.bounces), h.add(plan.channels);
  h.add(plan.error), h.add(plan.memory);
  return h.value;
}

}  // namespace saccade
