// How a camera forms its picture: size, intrinsics and lens distortion. Pure data.
#pragma once

#include <array>

namespace saccade {

enum class LensModel { kRadTan, kEquidistant };

// The default distorts nothing.
struct Distortion {
  LensModel model = LensModel::kRadTan;
  // k1 k2 p1 p2 k3 of kRadTan, k1 k2 k3 k4 of kEquidistant.
  std::array<double, 5> k{};

  // A lens without coefficients is a pinhole if it is radial-tangential, and a fisheye if it is equidistant.
  bool isNone() const { return *this == Distortion{}; }
  friend bool operator==(const Distortion&, const Distortion&) = default;
};

// Pixel (0, 0) is at the top left, and whole numbers are pixel centres.
struct CameraModel {
  int width = 1, height = 1;  // of the picture, pixels
  double fx = 1, fy = 1;      // focal lengths, pixels, > 0
  double cx = 0, cy = 0;      // the principal point, pixels
  Distortion distortion = {};

  double focal() const;  // where only a size is meant: the geometric mean of fx and fy
  friend bool operator==(const CameraModel&, const CameraModel&) = default;
};

// A camera with square pixels, whose principal point is the centre of the picture. 0 < fov_x_deg < 180.
CameraModel pinhole(double fov_x_deg, int width, int height);

// The horizontal field of view that pinhole() takes to give fx.
double fovXDeg(const CameraModel& camera);

// The same view in pixels of another size: the width of the picture stays, and so does its centre. The rows
// that the new height lacks or adds are at the top and at the bottom.
CameraModel resized(const CameraModel& camera, int width, int height);

}  // namespace saccade
