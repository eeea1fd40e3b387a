#include "client/options/camera_options.h"

#include <stdexcept>
#include <vector>

#include "client/calibration/calibration_reader.h"
#include "client/options/request_text.h"
#include "saccade/wire/ranges.h"

namespace saccade::client {
namespace {

v1::Intrinsics parseIntrinsics(const std::string& text) {
  const std::vector<double> values = parseNumbers(text);
  if (values.size() != 4) throw std::invalid_argument("--intrinsics: '" + text + "' is not FX,FY,CX,CY");
  v1::Intrinsics out;
  out.set_fx(values[0]), out.set_fy(values[1]), out.set_cx(values[2]), out.set_cy(values[3]);
  return out;
}

v1::Distortion parseDistortion(const std::string& text) {
  const auto [model, coefficients] = splitAt(text, ':');
  v1::Distortion out;
  out.set_model(enumValue<v1::DistortionModel>("--distortion", model));
  const std::vector<double> numbers = parseNumbers(coefficients);
  if (numbers.empty() && !coefficients.empty())
    throw std::invalid_argument("--distortion: '" + coefficients +
                                "' are not numbers with commas between them");
  for (const double k : numbers) out.add_coefficients(k);
  return out;
}

void setSize(const std::string& text, v1::View& view) {
  const ImageSize size = parseSize("--size", text);
  for (const std::uint32_t side : {size.width, size.height}) {
    if (side < ranges::kViewSide.min || side > ranges::kViewSide.max)
      throw std::invalid_argument("--size: '" + text + "': a side has " +
                                  std::to_string(ranges::kViewSide.min) + " to " +
                                  std::to_string(ranges::kViewSide.max) + " pixels");
  }
  view.set_width(size.width);
  view.set_height(size.height);
}

// A camera of a calibration, whose size --size may tell but not change.
void fitSize(const CameraOptions& options, v1::View& view) {
  const v1::View told = view;
  if (options.size.empty() && told.width() == 0)
    throw std::invalid_argument("--calibration: " + options.calibration + " has no size: give --size");
  if (options.size.empty()) return;
  setSize(options.size, view);
  if (told.width() > 0 && (told.width() != view.width() || told.height() != view.height()))
    throw std::invalid_argument("--size: '" + options.size + "': " + options.calibration + " is of " +
                                std::to_string(told.width()) + "x" + std::to_string(told.height()) +
                                " pixels");
}

std::vector<v1::View> readViews(const CameraOptions& options, double units_per_metre) {
  std::vector<v1::View> views;
  try {
    views = readCalibration(options.calibration, units_per_metre);
  } catch (const std::invalid_argument& fault) {
    throw std::invalid_argument(std::string("--calibration: ") + fault.what());
  }
  for (v1::View& view : views) fitSize(options, view);
  return views;
}

}  // namespace

void addCameraOptions(CLI::App& command, CameraOptions& o) {
  command.option_defaults()->group("Camera");
  command.add_option("--size", o.size, "WIDTHxHEIGHT in pixels")->default_str(o.default_size);
  CLI::Option* fov = command.add_option(
      "--fov", o.fov_x_deg,
      "horizontal field of view without the distortion, degrees; default: that of the scene");
  command
      .add_option("--intrinsics", o.intrinsics,
                  "FX,FY,CX,CY in pixels; the centre of the top left pixel is 0,0")
      ->excludes(fov);
  command.add_option("--distortion", o.distortion,
                     "of the lens: radtan:K1,K2,P1,P2 or radtan:K1,K2,P1,P2,K3 or equidistant:K1,K2,K3,K4");
  command
      .add_option(
          "--calibration", o.calibration,
          "FILE.yaml of Kalibr (all its cameras, and where they are), ROS camera_info or OpenCV, with "
          "size, intrinsics and distortion")
      ->excludes(fov)
      ->excludes("--intrinsics")
      ->excludes("--distortion");
}

std::vector<v1::View> makeViews(const CameraOptions& options, double units_per_metre) {
  if (!options.calibration.empty()) return readViews(options, units_per_metre);
  v1::View view;
  const std::string& size = options.size.empty() ? options.default_size : options.size;
  if (!size.empty()) setSize(size, view);
  if (options.fov_x_deg) view.set_fov_x_deg(*options.fov_x_deg);
  if (!options.intrinsics.empty()) *view.mutable_intrinsics() = parseIntrinsics(options.intrinsics);
  if (!options.distortion.empty()) *view.mutable_distortion() = parseDistortion(options.distortion);
  return {view};
}

std::string sizeNote(const CameraOptions& options) {
  if (options.intrinsics.empty() || !options.size.empty() || options.default_size.empty()) return {};
  return "--intrinsics are taken for images of " + options.default_size + "; --size says otherwise";
}

}  // namespace saccade::client
