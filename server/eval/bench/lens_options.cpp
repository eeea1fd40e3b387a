#include "eval/bench/lens_options.h"

#include <algorithm>
#include <sstream>

#include "scene/camera/lens.h"
#include "scene/files/text.h"

namespace saccade::eval {
namespace {

Distortion parseDistortion(const std::string& text) {
  const std::size_t colon = std::min(text.find(':'), text.size());
  const std::string model = text.substr(0, colon);
  const bool fisheye = model == "equidistant";
  Distortion out{.model = fisheye ? LensModel::kEquidistant : LensModel::kRadTan};
  std::istringstream list(text.substr(std::min(colon + 1, text.size())));
  std::size_t count = 0;
  bool numbers = fisheye || model == "radtan";
  for (std::string item; numbers && std::getline(list, item, ',');) {
    const auto value = parseNumber(item);
    numbers = value && count < out.k.size();
    if (numbers) out.k[count++] = *value;
  }
  if (numbers && (count == 4 || (count == 5 && !fisheye))) return out;
  throw CLI::ValidationError("--distortion",
                             "must be radtan:K1,K2,P1,P2[,K3] or equidistant:K1,K2,K3,K4, not " + text);
}

}  // namespace

void addLensOptions(CLI::App& app, LensOptions& o) {
  app.add_option(
         "--intrinsics", o.intrinsics,
         "FX,FY,CX,CY in pixels, instead of the scene's field of view; pixel centres are whole numbers")
      ->delimiter(',')
      ->expected(4);
  app.add_option("--distortion", o.distortion,
                 "of the lens: radtan:K1,K2,P1,P2[,K3] or equidistant:K1,K2,K3,K4");
}

CameraModel withLens(CameraModel camera, const LensOptions& o) {
  if (!o.intrinsics.empty()) {
    camera.fx = o.intrinsics[0], camera.fy = o.intrinsics[1];
    camera.cx = o.intrinsics[2], camera.cy = o.intrinsics[3];
  }
  if (!(camera.fx > 0 && camera.fy > 0))
    throw CLI::ValidationError("--intrinsics", "focal lengths must be positive");
  if (!o.distortion.empty()) camera.distortion = parseDistortion(o.distortion);
  const std::string fault = lensFault(camera);
  if (!fault.empty()) throw CLI::ValidationError("--distortion", fault);
  return camera;
}

}  // namespace saccade::eval
