// The numbers of a camera, as OpenCV, Kalibr and ROS have them.
#pragma once

#include <string>
#include <vector>

#include "saccade/v1/control.pb.h"

namespace saccade::client {

struct PinholeCamera {
  explicit PinholeCamera(const v1::View& view);  // a view without defaults

  std::vector<double> intrinsics() const { return {fx, fy, cx, cy}; }
  std::vector<double> matrix() const { return {fx, 0, cx, 0, fy, cy, 0, 0, 1}; }  // K, 3x3
  // Of the camera that is its own rectified one: 3x4, [K 0].
  std::vector<double> projection() const { return {fx, 0, cx, 0, 0, fy, cy, 0, 0, 0, 1, 0}; }
  std::string rosModel() const { return fisheye ? "equidistant" : "plumb_bob"; }
  std::string kalibrModel() const { return fisheye ? "equidistant" : "radtan"; }

  std::uint32_t width, height;     // pixels
  double fx, fy, cx, cy;           // pixels; whole numbers are pixel centres
  bool fisheye;                    // equidistant; otherwise radial-tangential
  std::vector<double> distortion;  // k1 k2 k3 k4 of fisheye, otherwise k1 k2 p1 p2 k3
};

}  // namespace saccade::client
