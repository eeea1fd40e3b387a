// cam_to_cam.yaml of DSEC. T_XY takes coordinates of camera Y to those of camera X. Each camera is its own
// rectified one, without its lens. The cameras are not rectified to pairs, so there is no disparity_to_depth.
#include "client/calibration/formats.h"
#include "client/calibration/lens_yaml.h"
#include "client/calibration/rig.h"
#include "saccade/stream_views.h"

namespace saccade::client {
namespace {

std::string intrinsicsYaml(const v1::View& view, const std::string& number) {
  const PinholeCamera camera(view);
  return "  cam" + number + ":\n" + lensYaml(camera, "    ", "camera_matrix") + "  camRect" + number +
         ":\n    camera_model: pinhole\n    camera_matrix: " + yamlList(camera.intrinsics()) + "\n" +
         resolutionYaml(camera, "    ");
}

}  // namespace

std::string dsecYaml(const v1::OpenStream& stream) {
  const double scale = metresPerUnit(stream);
  std::string intrinsics = "intrinsics:\n", extrinsics = "extrinsics:\n";
  for (std::uint32_t n = 0; n < viewsOf(stream); ++n) {
    const std::string number = std::to_string(n);
    intrinsics += intrinsicsYaml(viewOf(stream, n), number);
    extrinsics += "  R_rect" + number + ":\n" + yamlRows("    ", {1, 0, 0, 0, 1, 0, 0, 0, 1}, 3);
    if (n == 0) continue;
    const Transform T_n_previous =
        relative(bodyFromCamera(viewOf(stream, n), scale), bodyFromCamera(viewOf(stream, n - 1), scale));
    extrinsics += "  T_" + number + std::to_string(n - 1) + ":\n" + yamlRows("    ", T_n_previous);
  }
  return intrinsics + extrinsics;
}

}  // namespace saccade::client
