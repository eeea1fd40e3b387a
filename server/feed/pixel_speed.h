// How fast the picture of a feed moves, so that its frame rate can be chosen.
#pragma once

#include "base/units.h"
#include "render/render_scene.h"
#include "scene/camera/trajectory.h"

namespace saccade {

struct FeedConfig;

// Quantiles of the length of the motion vectors between consecutive frames, pixels per frame.
struct PixelSpeed {
  double p50 = 0, p99 = 0;
};

// Over pixels of a grid that show a surface, and frames spread over the first `frames` (0: no end), but no
// longer than the path goes, or its first period, or a minute. 0 where no surface is ever in view.
PixelSpeed measurePixelSpeed(const RenderScene& scene, const Trajectory& path, const FeedConfig& config,
                             FrameIndex frames);

}  // namespace saccade
