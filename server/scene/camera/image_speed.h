// The speed of the image when the camera moves.
#pragma once

#include <vector>

#include "scene/camera/lens.h"
#include "scene/camera/pose.h"
#include "scene/camera/sine_path.h"

namespace saccade {

// Visible points, in the axes of the camera.
using VisiblePoints = std::vector<Vec3d>;

// Those of the world-space `points` that lie in front; without any, one point on the viewing axis at
// distance 1.
VisiblePoints viewOf(const Pose& camera, const std::vector<Vec3d>& points);

double nearestDepth(const VisiblePoints& view);

// Velocity of the camera in its own axes, per second: linear in scene units, angular in radians.
struct Twist {
  Vec3d linear, angular;
};

// Of each point, in focal lengths per second.
std::vector<double> imageSpeeds(const VisiblePoints& view, const Twist& camera, const Lens& lens);

// Median over the view, in focal lengths per second: CameraModel::focal() pixels.
double medianImageSpeed(const VisiblePoints& view, const Twist& camera, const Lens& lens);

// Median over the view and the period, for a camera that has this view, in its axes, all the way.
double medianImageSpeed(const VisiblePoints& view, const SinePath& path, const Lens& lens);

// Appends how far the image of each point moves, in focal lengths, when the camera goes from one pose to
// another. Both are relative to the pose of the view. Points that are behind at either are left out.
void appendImageSteps(const VisiblePoints& view, const Pose& from, const Pose& to, const Lens& lens,
                      std::vector<double>& lengths);

}  // namespace saccade
