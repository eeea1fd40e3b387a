// sensor_msgs/CameraInfo, as camera_calibration_parsers of ROS reads it.
#include "client/calibration/formats.h"
#include "client/calibration/pinhole_camera.h"
#include "client/calibration/yaml.h"
#include "saccade/stream_views.h"

namespace saccade::client {
namespace {

std::string matrix(const std::string& name, int rows, const std::vector<double>& values) {
  return name + ":\n  rows: " + std::to_string(rows) +
         "\n  cols: " + std::to_string(values.size() / static_cast<std::size_t>(rows)) +
         "\n  data: " + yamlList(values) + "\n";
}

}  // namespace

std::string cameraInfoYaml(const v1::OpenStream& stream, std::uint32_t view) {
  const PinholeCamera camera(viewOf(stream, view));
  return "image_width: " + std::to_string(camera.width) + "\nimage_height: " + std::to_string(camera.height) +
         "\ncamera_name: cam" + std::to_string(view) + "\n" + matrix("camera_matrix", 3, camera.matrix()) +
         "distortion_model: " + camera.rosModel() + "\n" +
         matrix("distortion_coefficients", 1, camera.distortion) +
         matrix("rectification_matrix", 3, {1, 0, 0, 0, 1, 0, 0, 0, 1}) +
         matrix("projection_matrix", 3, camera.projection());
}

}  // namespace saccade::client
