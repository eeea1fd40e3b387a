// A feed renders a scene along a trajectory and estimates one IntensityChange per frame. All sensors of a
// stream share it.
#pragma once

#include <array>
#include <memory>
#include <span>

#include "base/pool_handle.h"
#include "feed/feed_config.h"
#include "feed/feed_interval.h"
#include "feed/feed_keys.h"
#include "feed/pixel_speed.h"
#include "feed/view_motion.h"
#include "frame/frame.h"
#include "frame/intensity_change.h"
#include "render/renderer.h"
#include "scene/camera/trajectory.h"

namespace saccade {

class Refinement;

class Feed {
 public:
  // Shares `scene`. Renders frame 0 on `pool`.
  Feed(std::shared_ptr<const RenderScene> scene, Trajectory path, const FeedConfig& config,
       const PoolHandle& pool);

  // With a method of the caller's instead of `config.method`, and the passes that it needs.
  Feed(std::shared_ptr<const RenderScene> scene, Trajectory path, const FeedConfig& config,
       std::unique_ptr<Method> method, SeedPlanner seeds, const PoolHandle& pool);

  ~Feed();

  // Adds keys to the paths, after the last ones.
  void steer(const FeedKeys& keys);

  // Renders the frame at `t`, which is later than the last one, and estimates the change since that. The
  // change stays as it is until the second step after this one begins.
  const IntensityChange& stepTo(TimeNs t, const PoolHandle& pool);
  // To the next frame at the rate of the configuration.
  const IntensityChange& step(const PoolHandle& pool) {
    return stepTo(frameTime(next_, config_.frame_rate_hz), pool);
  }

  // Whether the camera, all bodies and all lamps are at `t` as at the last frame.
  bool standsUntil(TimeNs t) const;
  // A step to `t` without a change, where standsUntil(t): renders nothing, and the frame of t0 becomes that
  // of t1. Not as the first step.
  const IntensityChange& holdTo(TimeNs t);

  // How far the picture moves from the last frame to the first of these times, and from one to the next. In
  // pixels: the 99th percentile over the surfaces that it shows.
  void measureMotion(std::span<const TimeNs> times, std::span<double> px);

  // Over the first `frames` intervals; 0: over all, see measurePixelSpeed().
  PixelSpeed pixelSpeed(FrameIndex frames) const;
  // The quantile of the luminance of frame 0, 0 <= fraction <= 1. Call it before any step.
  float firstFrameLuminance(double fraction) const;
  const StageTimes& lastTimes() const { return times_; }  // of the last step
  // The least wall time of the last step: its passes one after the other, each with all threads to itself.
  std::chrono::nanoseconds lastCriticalPath() const { return critical_path_; }
  const IntensityChange& change() const { return changes_[steps_ % 2]; }
  FeedInterval interval() const;                       // of the last step
  FramePair frames() const { return frames_.pair(); }  // at t1 and t0 of the last step; before any, only cur

  // Of the last step; nothing where the feed has whole frames only.
  const RefinementCounts& refined() const { return refined_; }
  const FeedConfig& config() const { return config_; }
  bool lampsChange() const { return !posed_[0].strengths().areSteady(); }  // over time

 private:
  void render(TimeNs t, const PoolHandle& pool);
  void refine(const PoolHandle& pool, IntensityChange& change);
  float bodiesReach(const FramePair& frames);
  IntensityChange& nextChange(TimeNs t0, TimeNs t1);
  Camera cameraAt(TimeNs t) const;
  const RenderScene& scene() const { return posed_[0].still(); }

  FeedConfig config_;
  Lens lens_;
  std::array<PosedScene, 2> posed_;  // at the times of two frames, in turn
  Trajectory path_;
  Renderer renderer_;
  std::unique_ptr<Method> method_;
  std::unique_ptr<Refinement> refinement_;  // nullptr: whole frames only
  RefinementCounts refined_;
  SeedPlanner seeds_;
  FrameRing frames_;
  std::array<IntensityChange, 2> changes_;  // in turn
  ViewMotion motion_;
  StageTimes times_;
  std::chrono::nanoseconds critical_path_{0};
  FrameIndex next_ = 0, steps_ = 0;  // frames rendered, and steps made
  bool held_ = false;                // the last step
};

}  // namespace saccade
