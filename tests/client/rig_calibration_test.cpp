// Calibrations of several cameras and an IMU: a point has the same place by the files as by the request.
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>

#include "client/calibration/calibration.h"

namespace saccade::client {
namespace {

using Point = std::array<double, 3>;

struct Mount {  // T_body_camera
  Point position;
  std::array<double, 4> rotation;  // x y z w, of unit length
};
const Mount kMounts[] = {{{0.1, -0.2, 0.3}, {0, 0, 0.6, 0.8}},
                         {{0.5, 0.1, 0}, {0.48, 0, 0.64, 0.6}},
                         {{-0.3, 0, 0.7}, {0, -0.28, 0, 0.96}}};
constexpr Point kInBody{1.5, -0.75, 4};

Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// kInBody in the axes of a camera: v + 2 w (u x v) + 2 u x (u x v) with the inverse rotation (u, w).
Point inCamera(const Mount& mount) {
  Point v, u;
  for (std::size_t i = 0; i < 3; ++i) v[i] = kInBody[i] - mount.position[i], u[i] = -mount.rotation[i];
  const Point uv = cross(u, v), uuv = cross(u, uv);
  for (std::size_t i = 0; i < 3; ++i) v[i] += 2 * mount.rotation[3] * uv[i] + 2 * uuv[i];
  return v;
}

v1::OpenStream rig() {
  v1::OpenStream stream;
  for (const Mount& m : kMounts) {
    v1::View& view = &m == kMounts ? *stream.mutable_view() : *stream.add_further_views();
    view.set_width(64), view.set_height(48), view.set_fov_x_deg(60);
    v1::Vector3& position = *view.mutable_body_camera()->mutable_position();
    position.set_x(m.position[0]), position.set_y(m.position[1]), position.set_z(m.position[2]);
    v1::Quaternion& q = *view.mutable_body_camera()->mutable_rotation();  // of any length
    q.set_x(3 * m.rotation[0]), q.set_y(3 * m.rotation[1]);
    q.set_z(3 * m.rotation[2]), q.set_w(3 * m.rotation[3]);
  }
  return stream;
}

v1::Imu& addImu(v1::OpenStream& stream) {
  v1::Truth& truth = *stream.add_truth();
  truth.set_name("imu");
  return *truth.mutable_imu();
}

std::string textOf(const std::string& ending, const v1::OpenStream& stream) {
  for (const CalibrationFile& file : calibrationFiles("a.h5", stream))
    if (file.name == "a.h5." + ending) return file.text;
  return {};
}

// The matrix of 4x4 after these keys, one after the other, times the point.
Point transformed(const std::string& text, const std::vector<std::string>& keys, const Point& point) {
  std::size_t at = 0;
  for (const std::string& key : keys) at = text.find(key + ":\n", at) + key.size();
  std::array<double, 16> m{};
  for (std::size_t i = 0; i < m.size(); ++i) {
    at = text.find_first_of("[,", at) + 1;
    if (text[at] == '\n') at = text.find('[', at) + 1;
    m[i] = std::strtod(text.c_str() + at, nullptr);
  }
  EXPECT_EQ((std::array{m[12], m[13], m[14], m[15]}), (std::array{0., 0., 0., 1.})) << text;
  Point result;
  for (std::size_t row = 0; row < 3; ++row)
    result[row] =
        m[4 * row] * point[0] + m[4 * row + 1] * point[1] + m[4 * row + 2] * point[2] + m[4 * row + 3];
  return result;
}

Point times(double scale, const Point& point) {
  return {scale * point[0], scale * point[1], scale * point[2]};
}

void expectNear(const Point& point, const Point& expected) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(point[i], expected[i], 1e-12) << i;
}

TEST(RigCalibration, TakesAPointFromCameraToCamera) {
  const v1::OpenStream stream = rig();
  const std::string kalibr = textOf("kalibr.yaml", stream), dsec = textOf("cam_to_cam.yaml", stream);
  for (std::size_t n = 1; n < 3; ++n) {
    const std::string to = std::to_string(n), from = std::to_string(n - 1);
    const Point previous = inCamera(kMounts[n - 1]), expected = inCamera(kMounts[n]);
    expectNear(transformed(kalibr, {"cam" + to, "T_cn_cnm1"}, previous), expected);
    expectNear(transformed(dsec, {"extrinsics", "T_" + to + from}, previous), expected);
  }
  EXPECT_LT(kalibr.find("cam1:"), kalibr.find("T_cn_cnm1"));  // the first camera has no previous one
  EXPECT_EQ(kalibr.find("T_cam_imu"), kalibr.npos);
  EXPECT_EQ(textOf("imu.yaml", stream), "");
}

TEST(RigCalibration, TheImuIsTheBodyInMetres) {
  constexpr double kMetres = 2.5;
  v1::OpenStream stream = rig();
  addImu(stream).set_metres_per_unit(kMetres);
  const std::string kalibr = textOf("kalibr.yaml", stream);
  for (std::size_t n = 0; n < 3; ++n) {
    const Point expected = times(kMetres, inCamera(kMounts[n]));
    const std::string camera = "cam" + std::to_string(n);
    expectNear(transformed(kalibr, {camera, "T_cam_imu"}, times(kMetres, kInBody)), expected);
    if (n == 0) continue;
    const Point previous = times(kMetres, inCamera(kMounts[n - 1]));
    expectNear(transformed(kalibr, {camera, "T_cn_cnm1"}, previous), expected);
  }
}

TEST(RigCalibration, EachCameraHasItsNumbersAndTopic) {
  v1::OpenStream stream = rig();
  stream.mutable_further_views(0)->set_width(100);
  EXPECT_NE(textOf("cam1.camera_info.yaml", stream).find("image_width: 100\n"), std::string::npos);
  EXPECT_NE(textOf("cam1.camera_info.yaml", stream).find("camera_name: cam1\n"), std::string::npos);
  const std::string kalibr = textOf("kalibr.yaml", stream);
  EXPECT_NE(kalibr.find("resolution: [100, 48]", kalibr.find("cam1:")), kalibr.npos) << kalibr;
  EXPECT_NE(kalibr.find("rostopic: /dvs/events\ncam1:"), kalibr.npos) << kalibr;
  EXPECT_NE(kalibr.find("rostopic: /dvs_1/events\ncam2:"), kalibr.npos) << kalibr;
  const std::string dsec = textOf("cam_to_cam.yaml", stream);
  EXPECT_NE(dsec.find("resolution: [100, 48]\n  cam2:", dsec.find("camRect1:")), dsec.npos) << dsec;
  EXPECT_NE(dsec.find("R_rect2:"), dsec.npos) << dsec;
}

TEST(RigCalibration, KalibrsImuHasTheNoiseOfTheRequest) {
  v1::OpenStream stream = rig();
  v1::Imu& imu = addImu(stream);
  imu.set_rate_hz(400);
  imu.set_accelerometer_noise(0.01), imu.set_gyroscope_noise(0.005);
  imu.set_accelerometer_walk(2e-4), imu.set_gyroscope_walk(4e-6);
  EXPECT_EQ(textOf("imu.yaml", stream),
            "accelerometer_noise_density: 0.01\naccelerometer_random_walk: 2.0e-04\n"
            "gyroscope_noise_density: 0.005\ngyroscope_random_walk: 4.0e-06\n"
            "rostopic: /dvs/imu\nupdate_rate: 400.0\n");
}

}  // namespace
}  // namespace saccade::client
