// Updates of pixels within an interval, so that brightness is right between both frames of a feed [ours].
//
// takes    both frames, and a method that knows light on surfaces
// returns  IntensityChange::updates: look-ups of pixels where brightness can have changed, and is no line
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "feed/feed_interval.h"
#include "feed/feed_keys.h"
#include "feed/refined_tile.h"

namespace saccade {

// Whether a feed can be refined: empty, or why it cannot, for a message.
std::string refinementFault(const FeedConfig& config);

class Refinement {
 public:
  // `config` has a refinement without fault. Shares `scene`.
  Refinement(const FeedConfig& config, std::shared_ptr<const RenderScene> scene);

  // Adds keys to the paths of bodies, after the last ones.
  void steer(const FeedKeys& keys);

  struct Interval {
    FramePair frames;  // with motion vectors, and equal strengths of lamps
    const PosedScene& scene;
    const FrameMotion motion;  // of the interval
    const float reach_px;      // how far surfaces and shadows move at least, see ViewMotion
    const SurfaceMethod& light;
    const FrameRays& rays;  // of the frame at its end
    const std::function<Camera(TimeNs)> cameraAt;
  };
  // Sets the updates of `change`, whose other parts are known. Returns the CPU time.
  std::chrono::nanoseconds refine(const Interval& interval, const PoolHandle& pool, IntensityChange& change);

  const RefinementCounts& lastCounts() const { return counts_; }  // of the last refine()

 private:
  static constexpr int kTileEdge = kRefinedTile;

  std::chrono::nanoseconds measureMotion(const FramePair& frames, const PoolHandle& pool);
  std::chrono::nanoseconds findBrightness(const IntensityChange& change, const PoolHandle& pool);
  float motionAround(int tile) const;
  int levelsFor(float motion_px) const;
  void setMoments(const Interval& interval, int levels, const IntensityChange& change);
  void join(IntensityChange& change);

  RefinementSettings settings_;
  int spp_, width_, height_, across_, down_;  // across, down: tiles
  std::vector<float> motion_px_;              // by tile: the longest motion of its pixels
  ImageF L0_, L1_;
  std::vector<Camera> cameras_;
  std::vector<PosedScene> posed_;  // by moment, in a scene with bodies
  std::vector<const PosedScene*> scenes_;
  std::vector<RefinedTile> tiles_;
  std::vector<std::size_t> joined_;  // of the updates of each tile
  RefinementCounts counts_;
};

}  // namespace saccade
