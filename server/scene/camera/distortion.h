// Lens distortion. It maps the point (x / z, y / z) of an ideal pinhole to the point where the lens shows it.
// Both lie in the plane at distance 1. Sources: OpenCV, modules calib3d (radial-tangential, "plumb_bob") and
// fisheye (equidistant, Kannala and Brandt 2006). Kalibr and ROS have the same formulas.
#pragma once

#include <optional>

#include "scene/camera/camera_model.h"

namespace saccade {

struct PlanePoint {
  double x = 0, y = 0;
};

// The derivative of a map of the plane: xy is that of x by y.
struct PlaneMap {
  double xx = 1, xy = 0, yx = 0, yy = 1;
  double determinant() const { return xx * yy - xy * yx; }
};

PlanePoint distort(const Distortion& lens, PlanePoint p);
PlaneMap distortionSlope(const Distortion& lens, PlanePoint p);  // at p

// The inverse of distort() near `start`, by Newton's method. None where it does not converge within a bound
// on its steps, or where the lens folds the plane.
std::optional<PlanePoint> undistort(const Distortion& lens, PlanePoint shown, PlanePoint start);

// The same on the sheet of the plane that holds its centre: goes there from the centre in small steps. None
// where the lens folds before, and beyond kMaxLensAngleDeg.
std::optional<PlanePoint> undistortFromCentre(const Distortion& lens, PlanePoint shown);

inline constexpr double kMaxLensAngleDeg = 85;  // from the viewing axis

}  // namespace saccade
