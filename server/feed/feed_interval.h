// What a feed has made of one interval between two frames.
#pragma once

#include "frame/frame.h"
#include "frame/intensity_change.h"
#include "render/camera.h"
#include "render/render_scene.h"
#include "scene/camera/trajectory.h"

namespace saccade {

// References hold until the feed's next step.
struct FeedInterval {
  const IntensityChange& change;
  FramePair frames;          // at t1 and at t0
  Camera camera, camera_t0;  // likewise
  const Trajectory& path;    // of the camera
  const RenderScene& scene;
};

}  // namespace saccade
