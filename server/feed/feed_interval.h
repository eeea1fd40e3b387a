// The result of a feed for one interval between two frames.
#pragma once

#include <optional>

#include "frame/frame.h"
#include "frame/intensity_change.h"
#include "render/camera/camera.h"
#include "scene/camera/trajectory.h"

namespace saccade {

class PosedScene;

// The renderer's part of an interval.
struct RenderedInterval {
  FramePair frames;          // at t1 and at t0
  Camera camera, camera_t0;  // likewise
  const Trajectory& path;    // of the camera
  const PosedScene &scene, &scene_t0;
};

// References hold until the feed's next step.
struct FeedInterval {
  const IntensityChange& change;
  std::optional<RenderedInterval> rendered;  // nothing where a client has sent the frames
  // The first frame of the stream at t1 or later, and whether it is at t1: frames may have several intervals.
  FrameIndex frame = change.frame;
  bool ends_frame = true;

  FrameIndex reachedFrame() const { return ends_frame ? frame : frame - 1; }  // the last one at t1 or earlier
};

}  // namespace saccade
