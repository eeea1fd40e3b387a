// How fast the picture of a feed moves: clients choose the frame rate by it.
#pragma once

#include "base/units.h"
#include "scene/camera/trajectory.h"

namespace saccade {

class RenderScene;

struct FeedConfig;

// Quantiles of the length of the motion vectors between consecutive frames, pixels per frame.
struct PixelSpeed {
  double p50 = 0, p99 = 0;
};

// Of the first `frames` frames (0: all) those within the path's duration, or its first period, or a minute;
// at least one.
FrameIndex framesToLookAt(const Trajectory& path, double rate_hz, FrameIndex frames);

// Samples a grid of pixels in up to 16 of framesToLookAt(). 0 where no surface is ever in view.
PixelSpeed measurePixelSpeed(const RenderScene& scene, const Trajectory& path, const FeedConfig& config,
                             FrameIndex frames);

}  // namespace saccade
