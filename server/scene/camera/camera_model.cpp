#include "scene/camera/camera_model.h"

#include <cmath>
#include <numbers>

namespace saccade {
namespace {

constexpr double kHalfDegree = std::numbers::pi / 360;

}  // namespace

double CameraModel::focal() const {
  return std::sqrt(fx * fy);
}

CameraModel pinhole(double fov_x_deg, int width, int height) {
  const double f = width / 2.0 / std::tan(fov_x_deg * kHalfDegree);
  return {
      .width = width, .height = height, .fx = f, .fy = f, .cx = 0.5 * (width - 1), .cy = 0.5 * (height - 1)};
}

double fovXDeg(const CameraModel& camera) {
  return std::atan(camera.width / 2.0 / camera.fx) / kHalfDegree;
}

CameraModel resized(const CameraModel& camera, int width, int height) {
  const double scale = static_cast<double>(width) / camera.width;
  CameraModel out{.width = width, .height = height, .fx = camera.fx * scale, .fy = camera.fy * scale};
  out.cx = 0.5 * (width - 1) + (camera.cx - 0.5 * (camera.width - 1)) * scale;
  out.cy = 0.5 * (height - 1) + (camera.cy - 0.5 * (camera.height - 1)) * scale;
  out.distortion = camera.distortion;
  return out;
}

}  // namespace saccade
