#include "client/calibration.h"

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

namespace saccade::client {
namespace {

constexpr const char* kTopic = "/dvs/events";  // as in bags

// With a point: readers of YAML 1.1 take 1e-05 for a text.
std::string number(double value) {
  std::array<char, 32> digits;
  std::string text(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
  if (text.find('.') == text.npos) text.insert(std::min(text.find('e'), text.size()), ".0");
  return text;
}

std::string list(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ", ") + number(value);
  return "[" + text + "]";
}

struct Camera {
  double fx, fy, cx, cy;
  std::vector<double> distortion;
  bool fisheye;
  std::string resolution;

  explicit Camera(const v1::View& view)
      : distortion(view.distortion().coefficients().begin(), view.distortion().coefficients().end()),
        fisheye(view.distortion().model() == v1::DISTORTION_MODEL_EQUIDISTANT),
        resolution("[" + std::to_string(view.width()) + ", " + std::to_string(view.height()) + "]") {
    distortion.resize(fisheye ? 4 : 5);
    if (view.has_intrinsics()) {
      const v1::Intrinsics& k = view.intrinsics();
      fx = k.fx(), fy = k.fy(), cx = k.cx(), cy = k.cy();
    } else {
      fx = fy = view.width() / 2.0 / std::tan(view.fov_x_deg() * std::numbers::pi / 360);
      cx = 0.5 * (view.width() - 1.0), cy = 0.5 * (view.height() - 1.0);
    }
  }
  std::vector<double> intrinsics() const { return {fx, fy, cx, cy}; }
  std::vector<double> fourCoefficients() const { return {distortion.begin(), distortion.begin() + 4}; }
  std::string kalibrModel() const { return fisheye ? "equidistant" : "radtan"; }
};

std::string matrix(const std::string& name, int rows, const std::vector<double>& values) {
  return name + ":\n  rows: " + std::to_string(rows) +
         "\n  cols: " + std::to_string(values.size() / static_cast<std::size_t>(rows)) +
         "\n  data: " + list(values) + "\n";
}

std::string cameraInfo(const v1::View& view) {
  const Camera c(view);
  return "image_width: " + std::to_string(view.width()) + "\nimage_height: " + std::to_string(view.height()) +
         "\ncamera_name: cam0\n" + matrix("camera_matrix", 3, {c.fx, 0, c.cx, 0, c.fy, c.cy, 0, 0, 1}) +
         "distortion_model: " + (c.fisheye ? "equidistant" : "plumb_bob") + "\n" +
         matrix("distortion_coefficients", 1, c.distortion) +
         matrix("rectification_matrix", 3, {1, 0, 0, 0, 1, 0, 0, 0, 1}) +
         matrix("projection_matrix", 3, {c.fx, 0, c.cx, 0, 0, c.fy, c.cy, 0, 0, 0, 1, 0});
}

std::string kalibr(const v1::View& view) {
  const Camera c(view);
  return "cam0:\n  camera_model: pinhole\n  intrinsics: " + list(c.intrinsics()) +
         "\n  distortion_model: " + c.kalibrModel() + "\n  distortion_coeffs: " + list(c.fourCoefficients()) +
         "\n  resolution: " + c.resolution + "\n  rostopic: " + kTopic + "\n";
}

std::string dsec(const v1::View& view) {
  const Camera c(view);
  return "intrinsics:\n  cam0:\n    camera_model: pinhole\n    camera_matrix: " + list(c.intrinsics()) +
         "\n    distortion_model: " + c.kalibrModel() +
         "\n    distortion_coeffs: " + list(c.fourCoefficients()) + "\n    resolution: " + c.resolution +
         "\n  camRect0:\n    camera_model: pinhole\n    camera_matrix: " + list(c.intrinsics()) +
         "\n    resolution: " + c.resolution +
         "\nextrinsics:\n  R_rect0:\n    - [1.0, 0.0, 0.0]\n    - [0.0, 1.0, 0.0]\n    - [0.0, 0.0, 1.0]\n";
}

}  // namespace

std::vector<CalibrationFile> calibrationFiles(const std::string& path, const v1::View& view) {
  std::vector<CalibrationFile> files{{path + ".camera_info.yaml", cameraInfo(view)},
                                     {path + ".kalibr.yaml", kalibr(view)}};
  if (path.ends_with(".h5")) files.push_back({path + ".cam_to_cam.yaml", dsec(view)});
  return files;
}

std::string calibrationFault(const v1::View& view) {
  const auto& k = view.distortion().coefficients();
  if (k.size() < 5 || k[4] == 0) return {};
  return "Kalibr and DSEC know no k3: give radtan four coefficients";
}

}  // namespace saccade::client
