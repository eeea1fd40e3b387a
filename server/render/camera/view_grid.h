// The view of a camera on a grid of rays, for measurements that do not need every pixel.
#pragma once

#include <vector>

#include "render/camera/camera.h"
#include "render/world/render_scene.h"

namespace saccade {

// Cells of equal size that cover a picture.
struct ViewGrid {
  int width, height;  // of the picture, pixels
  int columns, rows;
};

// The first surface that a ray of the camera hits.
struct ViewHit {
  float x, y;  // where the picture shows it, pixels
  float z;     // depth along the viewing axis
};

// Traces one ray through the centre of each cell, row by row. Rays that hit nothing are left out.
std::vector<ViewHit> viewHits(const RenderScene& scene, const Camera& camera, const ViewGrid& grid);

// World-space points on the surfaces in view, on a grid over the picture, which is cut or extended to 4:3
// where there is no distortion. Empty if nothing is in view.
std::vector<Vec3d> probePoints(const RenderScene& scene, const Pose& T_world_camera, const Lens& lens);

}  // namespace saccade
