#include "app/request/resolve_view.h"
#include "app/request/enum_names.h"
#include "app/request/refusal.h"

namespace saccade {
namespace {

void checkIntrinsics(const v1::View& view, const std::string& field) {
  if (view.has_fov_x_deg()) refuse(field, "give intrinsics or fov_x_deg, not both");
  const v1::Intrinsics& given = view.intrinsics();
  checkRange(field + ".fx", given.fx(), ranges::kFocalLength);
  checkRange(field + ".fy", given.fy(), ranges::kFocalLength);
  checkRange(field + ".cx", given.cx(), ranges::kPrincipalPoint);
  checkRange(field + ".cy", given.cy(), ranges::kPrincipalPoint);
}

Distortion distortionOf(const v1::Distortion& given, const std::string& field) {
  if (given.model() == v1::DISTORTION_MODEL_UNSPECIFIED)
    refuse(field + ".model", "give DISTORTION_MODEL_RADTAN or DISTORTION_MODEL_EQUIDISTANT");
  resolveEnum(field + ".model", given.model(), v1::DISTORTION_MODEL_UNSPECIFIED);
  const bool fisheye = given.model() == v1::DISTORTION_MODEL_EQUIDISTANT;
  const int count = given.coefficients_size();
  if (count != 4 && (fisheye || count != 5))
    refuse(field + ".coefficients",
           fisheye ? "equidistant takes k1, k2, k3, k4" : "radtan takes k1, k2, p1, p2, and k3 or not");
  Distortion out{.model = fisheye ? LensModel::kEquidistant : LensModel::kRadTan};
  for (int i = 0; i < count; ++i) {
    checkRange(field + ".coefficients[" + std::to_string(i) + "]", given.coefficients(i),
               ranges::kDistortion);
    out.k[static_cast<std::size_t>(i)] = given.coefficients(i);
  }
  return out;
}

// `view` has a field of view or intrinsics.
CameraModel cameraOf(const v1::View& view, const std::string& field) {
  const int width = static_cast<int>(view.width()), height = static_cast<int>(view.height());
  CameraModel camera = pinhole(view.fov_x_deg(), width, height);
  if (view.has_intrinsics()) {
    const v1::Intrinsics& given = view.intrinsics();
    camera.fx = given.fx(), camera.fy = given.fy(), camera.cx = given.cx(), camera.cy = given.cy();
  }
  if (!view.has_distortion()) return camera;
  camera.distortion = distortionOf(view.distortion(), field + ".distortion");
  if (const std::string fault = lensFault(camera); !fault.empty()) refuse(field + ".distortion", fault);
  return camera;
}

}  // namespace

CameraModel resolveView(const v1::View& view, const std::string& field) {
  checkRange(field + ".width", view.width(), ranges::kViewSide);
  checkRange(field + ".height", view.height(), ranges::kViewSide);
  if (view.width() * view.height() > ranges::kMaxViewPixels)
    refuse(field, "a view has at most " + std::to_string(ranges::kMaxViewPixels) + " pixels");
  if (view.has_intrinsics()) checkIntrinsics(view, field + ".intrinsics");
  if (view.has_fov_x_deg()) checkRange(field + ".fov_x_deg", view.fov_x_deg(), ranges::kFovX);
  if (view.has_fov_x_deg() || view.has_intrinsics()) return cameraOf(view, field);
  CameraModel camera{.width = static_cast<int>(view.width()), .height = static_cast<int>(view.height())};
  if (view.has_distortion()) camera.distortion = distortionOf(view.distortion(), field + ".distortion");
  return camera;
}

CameraModel fitView(const Scene& scene, v1::View& view, const std::string& field) {
  if (!view.has_fov_x_deg() && !view.has_intrinsics()) view.set_fov_x_deg(scene.fov_x_deg);
  return cameraOf(view, field);
}

}  // namespace saccade
