#include "client/calibration/calibration_reader.h"

#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "client/calibration/camera_readers.h"

namespace saccade::client {

std::vector<v1::View> readCalibration(const std::string& path, double units_per_metre) {
  const YamlMapping file = YamlMapping::ofFile(path);
  if (file.has("cam0")) return readKalibr(file, units_per_metre);
  if (file.has("camera_matrix") || file.has("K") || file.has("k")) return {readCameraInfo(file)};
  throw std::invalid_argument(
      path +
      ": is no calibration: there is neither cam0 (Kalibr) nor camera_matrix (OpenCV, "
      "ROS) nor K (a message of ROS)");
}

v1::Imu readImuCalibration(const std::string& path) {
  const YamlMapping file = YamlMapping::ofFile(path);
  v1::Imu imu;
  imu.set_accelerometer_noise(file.number("accelerometer_noise_density"));
  imu.set_accelerometer_walk(file.number("accelerometer_random_walk"));
  imu.set_gyroscope_noise(file.number("gyroscope_noise_density"));
  imu.set_gyroscope_walk(file.number("gyroscope_random_walk"));
  imu.set_rate_hz(file.number("update_rate"));
  return imu;
}

void setSize(const YamlMapping& file, const std::string& key, double width, double height, v1::View& view) {
  for (const double side : {width, height})
    if (side < 1 || side > 1e6 || side != std::floor(side)) file.fail(key, "is no size in pixels");
  view.set_width(static_cast<std::uint32_t>(width));
  view.set_height(static_cast<std::uint32_t>(height));
}

void setIntrinsics(double fx, double fy, double cx, double cy, v1::View& view) {
  v1::Intrinsics& k = *view.mutable_intrinsics();
  k.set_fx(fx), k.set_fy(fy), k.set_cx(cx), k.set_cy(cy);
}

void setDistortion(const YamlMapping& file, const std::string& key, v1::DistortionModel model,
                   std::vector<double> coefficients, v1::View& view) {
  const bool fisheye = model == v1::DISTORTION_MODEL_EQUIDISTANT;
  while (coefficients.size() > (fisheye ? 4 : 5)) {
    if (coefficients.back() != 0)
      file.fail(key, fisheye ? "has more than k1 k2 k3 k4" : "has more than k1 k2 p1 p2 k3");
    coefficients.pop_back();
  }
  if (coefficients.empty()) return;
  if (coefficients.size() < 4) file.fail(key, "has fewer than 4 numbers");
  v1::Distortion& lens = *view.mutable_distortion();
  lens.set_model(model);
  for (const double k : coefficients) lens.add_coefficients(k);
}

}  // namespace saccade::client
