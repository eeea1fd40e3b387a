// Optical flow: where the surfaces that a frame shows lie in a neighbouring frame.
#pragma once

#include <string>

#include "frame/frame.h"
#include "render/camera/camera.h"
#include "render/world/posed_scene.h"

namespace saccade {

// A frame's features, and the camera and the scene that it was rendered with.
struct FlowView {
  const GBuffer& g;
  const Camera& camera;
  const PosedScene& scene;
};

// By how much of its depth a surface may seem to be elsewhere, for rounding and curvature.
inline constexpr float kFlowDepthTolerance = 1e-3f;

// The planes x, y and valid as float32, row by row from the top. Planes x and y are the position of the
// surface in `there` minus its position in `here`, in pixels. They are 0 where it is behind the camera.
// valid is 1 where `there` shows the surface too, else 0. It does if the depth of the pixel nearest to
// the position differs by at most the sum of two parts. One is kFlowDepthTolerance of the depth, and one
// the distance to that pixel's centre times the steeper of both slopes.
std::string flowPlanes(const FlowView& here, const FlowView& there);

}  // namespace saccade
