#include "client/calibration/pinhole_camera.h"

#include <cmath>
#include <numbers>

namespace saccade::client {

PinholeCamera::PinholeCamera(const v1::View& view)
    : width(view.width()),
      height(view.height()),
      fisheye(view.distortion().model() == v1::DISTORTION_MODEL_EQUIDISTANT),
      distortion(view.distortion().coefficients().begin(), view.distortion().coefficients().end()) {
  distortion.resize(fisheye ? 4 : 5);
  if (view.has_intrinsics()) {
    const v1::Intrinsics& k = view.intrinsics();
    fx = k.fx(), fy = k.fy(), cx = k.cx(), cy = k.cy();
  } else {
    fx = fy = width / 2.0 / std::tan(view.fov_x_deg() * std::numbers::pi / 360);
    cx = 0.5 * (width - 1.0), cy = 0.5 * (height - 1.0);
  }
}

}  // namespace saccade::client
