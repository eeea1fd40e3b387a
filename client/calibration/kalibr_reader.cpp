// A camchain of Kalibr.
#include <algorithm>

#include "client/calibration/camera_readers.h"
#include "client/calibration/rig.h"
#include "client/calibration/rotation.h"

namespace saccade::client {
namespace {

constexpr Transform kIdentity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

void readLens(const YamlMapping& camera, v1::View& view) {
  const std::string model = "distortion_model", key = "distortion_coeffs";
  const std::string name = camera.has(model) ? camera.text(model) : "none";
  if (name == "none") return;
  if (name != "radtan" && name != "equidistant")
    camera.fail(model, "is '" + name + "'; there are: radtan, equidistant, none");
  setDistortion(camera, key,
                name == "radtan" ? v1::DISTORTION_MODEL_RADTAN : v1::DISTORTION_MODEL_EQUIDISTANT,
                camera.numbers(key), view);
}

v1::View readCamera(const YamlMapping& camera) {
  if (camera.text("camera_model") != "pinhole")
    camera.fail("camera_model", "is '" + camera.text("camera_model") + "'; there is: pinhole");
  v1::View view;
  const std::vector<double> size = camera.numbers("resolution", 2);
  setSize(camera, "resolution", size[0], size[1], view);
  const std::vector<double> k = camera.numbers("intrinsics", 4);
  setIntrinsics(k[0], k[1], k[2], k[3], view);
  readLens(camera, view);
  return view;
}

Transform readTransform(const YamlMapping& camera, const std::string& key) {
  const std::vector<double> numbers = camera.numbers(key, 16);
  Transform transform;
  std::copy(numbers.begin(), numbers.end(), transform.begin());
  const auto& m = transform;
  if (!isRotation({{{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}}}) || m[15] != 1)
    camera.fail(key, "is no rigid transform of 4x4 numbers");
  return transform;
}

// T_body_camera: of the IMU, or else by the camera before.
Transform bodyOf(const YamlMapping& camera, const Transform& T_body_previous) {
  if (camera.has("T_cam_imu")) return inverse(readTransform(camera, "T_cam_imu"));
  if (!camera.has("T_cn_cnm1")) return T_body_previous;
  return product(T_body_previous, inverse(readTransform(camera, "T_cn_cnm1")));
}

}  // namespace

std::vector<v1::View> readKalibr(const YamlMapping& file, double units_per_metre) {
  std::vector<v1::View> views;
  Transform T_body_camera = kIdentity;
  for (std::string name = "cam0"; file.has(name); name = "cam" + std::to_string(views.size())) {
    const YamlMapping camera = file.mapping(name);
    if (!views.empty() && !camera.has("T_cam_imu") && !camera.has("T_cn_cnm1"))
      camera.fail("T_cn_cnm1", "is missing: nothing tells where this camera is");
    T_body_camera = bodyOf(camera, T_body_camera);
    views.push_back(readCamera(camera));
    if (T_body_camera != kIdentity)
      *views.back().mutable_body_camera() = rigidTransform(T_body_camera, units_per_metre);
  }
  return views;
}

}  // namespace saccade::client
