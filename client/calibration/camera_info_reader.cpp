// sensor_msgs/CameraInfo, as a file of camera_calibration_parsers or as a printed message. A camera in the
// YAML of OpenCV has the same keys as such a file, and names no model.
#include "client/calibration/camera_readers.h"

namespace saccade::client {
namespace {

// The first of two spellings that the file has.
std::string either(const YamlMapping& file, const std::string& first, const std::string& second) {
  return file.has(first) || !file.has(second) ? first : second;
}

v1::DistortionModel modelOf(const YamlMapping& file) {
  if (file.has("fisheye_model") && file.number("fisheye_model") != 0) return v1::DISTORTION_MODEL_EQUIDISTANT;
  const std::string key = "distortion_model";
  if (!file.has(key)) return v1::DISTORTION_MODEL_RADTAN;
  const std::string model = file.text(key);
  if (model == "plumb_bob" || model == "rational_polynomial" || model.empty())
    return v1::DISTORTION_MODEL_RADTAN;  // which have their first five coefficients in common
  if (model == "equidistant" || model == "fisheye") return v1::DISTORTION_MODEL_EQUIDISTANT;
  file.fail(key, "is '" + model + "'; there are: plumb_bob, equidistant");
}

void readSize(const YamlMapping& file, v1::View& view) {
  const std::string width = either(file, "image_width", "width");
  const std::string height = either(file, "image_height", "height");
  if (!file.has(width) && !file.has(height)) return;
  setSize(file, width, file.number(width), file.number(height), view);
}

}  // namespace

v1::View readCameraInfo(const YamlMapping& file) {
  v1::View view;
  readSize(file, view);
  const std::string matrix = file.has("camera_matrix") ? "camera_matrix" : either(file, "K", "k");
  const std::vector<double> k = file.numbers(matrix, 9);
  if (k[1] != 0 || k[3] != 0 || k[6] != 0 || k[7] != 0 || k[8] != 1)
    file.fail(matrix, "is not of the form fx 0 cx 0 fy cy 0 0 1");
  setIntrinsics(k[0], k[4], k[2], k[5], view);
  const std::string lens =
      file.has("distortion_coefficients") ? "distortion_coefficients" : either(file, "D", "d");
  if (file.has(lens)) setDistortion(file, lens, modelOf(file), file.numbers(lens), view);
  return view;
}

}  // namespace saccade::client
