#include "client/commands/camera_options.h"

#include <stdexcept>
#include <vector>

#include "client/commands/request_text.h"
#include "saccade/wire/ranges.h"

namespace saccade::client {
namespace {

std::vector<double> parseList(const std::string& option, const std::string& text) {
  std::vector<double> values;
  for (auto [head, rest] = splitAt(text, ','); !head.empty() || !rest.empty();
       std::tie(head, rest) = splitAt(rest, ',')) {
    const auto value = parseNumber<double>(head);
    if (!value) throw std::invalid_argument(option + ": '" + head + "' is not a number");
    values.push_back(*value);
  }
  return values;
}

v1::Intrinsics parseIntrinsics(const std::string& text) {
  const std::vector<double> values = parseList("--intrinsics", text);
  if (values.size() != 4) throw std::invalid_argument("--intrinsics: '" + text + "' is not FX,FY,CX,CY");
  v1::Intrinsics out;
  out.set_fx(values[0]), out.set_fy(values[1]), out.set_cx(values[2]), out.set_cy(values[3]);
  return out;
}

v1::Distortion parseDistortion(const std::string& text) {
  const auto [model, coefficients] = splitAt(text, ':');
  v1::Distortion out;
  out.set_model(enumValue<v1::DistortionModel>("--distortion", model));
  for (const double k : parseList("--distortion", coefficients)) out.add_coefficients(k);
  return out;
}

void setSize(const CameraOptions& options, v1::View& view) {
  const ImageSize size = parseSize("--size", options.size);
  for (const std::uint32_t side : {size.width, size.height}) {
    if (side < ranges::kViewSide.min || side > ranges::kViewSide.max)
      throw std::invalid_argument("--size: '" + options.size + "': a side has " +
                                  std::to_string(ranges::kViewSide.min) + " to " +
                                  std::to_string(ranges::kViewSide.max) + " pixels");
  }
  view.set_width(size.width);
  view.set_height(size.height);
}

}  // namespace

void addCameraOptions(CLI::App& command, CameraOptions& o) {
  command.option_defaults()->group("Camera");
  command.add_option("--size", o.size, "WIDTHxHEIGHT in pixels")->capture_default_str();
  CLI::Option* fov =
      command.add_option("--fov", o.fov_x_deg, "horizontal field of view without the distortion, degrees");
  command
      .add_option("--intrinsics", o.intrinsics,
                  "FX,FY,CX,CY in pixels; the centre of the top left pixel is 0,0")
      ->excludes(fov);
  command.add_option("--distortion", o.distortion,
                     "of the lens: radtan:K1,K2,P1,P2 or radtan:K1,K2,P1,P2,K3 or equidistant:K1,K2,K3,K4");
}

v1::View makeView(const CameraOptions& options) {
  v1::View view;
  if (!options.size.empty()) setSize(options, view);
  if (options.fov_x_deg) view.set_fov_x_deg(*options.fov_x_deg);
  if (!options.intrinsics.empty()) *view.mutable_intrinsics() = parseIntrinsics(options.intrinsics);
  if (!options.distortion.empty()) *view.mutable_distortion() = parseDistortion(options.distortion);
  return view;
}

}  // namespace saccade::client
