// Calibrations as Kalibr, ROS and OpenCV write them. The files follow the examples of their documentation.
#include "client/calibration/calibration_reader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <stdexcept>

#include "client/calibration/calibration.h"
#include "scratch_folder.h"

namespace saccade::client {
namespace {

class CalibrationReader : public testing::Test {
 protected:
  std::vector<v1::View> read(const std::string& text, double units_per_metre = 1) {
    std::ofstream(path_) << text;
    return readCalibration(path_, units_per_metre);
  }
  std::string faultOf(const std::string& text) {
    try {
      read(text);
    } catch (const std::invalid_argument& fault) {
      return std::string(fault.what()).substr(path_.size());
    }
    return "none";
  }

  const ScratchFolder folder_;
  const std::string path_ = folder_.at("cam.yaml");
};

void expectCamera(const v1::View& view, v1::DistortionModel model, const std::vector<double>& lens) {
  EXPECT_EQ(view.width(), 346u);
  EXPECT_EQ(view.height(), 260u);
  EXPECT_EQ(view.intrinsics().fx(), 250.5);
  EXPECT_EQ(view.intrinsics().fy(), 251.5);
  EXPECT_EQ(view.intrinsics().cx(), 170.25);
  EXPECT_EQ(view.intrinsics().cy(), 131);
  EXPECT_EQ(view.distortion().model(), model);
  const auto& k = view.distortion().coefficients();
  EXPECT_EQ(std::vector<double>(k.begin(), k.end()), lens);
}

const std::string kKalibr =
    "cam0:\n  camera_model: pinhole\n  intrinsics: [250.5, 251.5, 170.25, 131.0]\n"
    "  distortion_model: equidistant\n  distortion_coeffs: [0.1, 0.02, -3.0e-3, 0.0004]\n"
    "  resolution: [346, 260]\n";
const std::string kOpenCv =
    "%YAML:1.0\n---\nimage_width: 346\nimage_height: 260\n"
    "camera_matrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
    "   data: [ 2.505e+02, 0., 1.7025e+02, 0., 251.5, 131., 0., 0., 1. ]\n"
    "distortion_coefficients: !!opencv-matrix\n   rows: 5\n   cols: 1\n   dt: d\n"
    "   data: [ -0.1, 0.02, 1e-3, -2e-3, 0.003 ]\n";

TEST_F(CalibrationReader, AFileOfOpenCvIsRead) {
  const auto views = read(kOpenCv);
  ASSERT_EQ(views.size(), 1u);
  expectCamera(views[0], v1::DISTORTION_MODEL_RADTAN, {-0.1, 0.02, 1e-3, -2e-3, 0.003});
  EXPECT_FALSE(views[0].has_body_camera());
}

TEST_F(CalibrationReader, AMessageOfRosIsRead) {
  const auto views = read(
      "header:\n  frame_id: cam\nheight: 260\nwidth: 346\ndistortion_model: equidistant\n"
      "D: [0.1, 0.02, -0.003, 0.0004]\nK: [250.5, 0.0, 170.25, 0.0, 251.5, 131.0, 0.0, 0.0, 1.0]\n---\n");
  ASSERT_EQ(views.size(), 1u);
  expectCamera(views[0], v1::DISTORTION_MODEL_EQUIDISTANT, {0.1, 0.02, -0.003, 0.0004});
}

TEST_F(CalibrationReader, ACamchainOfKalibrIsRead) {
  const auto views = read(kKalibr);
  ASSERT_EQ(views.size(), 1u);
  expectCamera(views[0], v1::DISTORTION_MODEL_EQUIDISTANT, {0.1, 0.02, -0.003, 0.0004});
}

// T_cam_imu takes points of the IMU to those of the camera. Here the camera is 0.1 m along x of the IMU, and
// turned by 90 degrees about z. It sees the origin of the IMU at R^T (0 - t) = (0, 0.1, 0).
TEST_F(CalibrationReader, TheBodyIsTheImu) {
  const auto views = read(kKalibr +
                              "  T_cam_imu:\n  - [0.0, 1.0, 0.0, 0.0]\n  - [-1.0, 0.0, 0.0, 0.1]\n"
                              "  - [0.0, 0.0, 1.0, 0.0]\n  - [0.0, 0.0, 0.0, 1.0]\n",
                          2);
  const v1::RigidTransform& body_camera = views[0].body_camera();
  EXPECT_NEAR(body_camera.position().x(), 0.2, 1e-12);
  EXPECT_NEAR(body_camera.position().y(), 0, 1e-12);
  EXPECT_NEAR(body_camera.rotation().z(), std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(body_camera.rotation().w(), std::sqrt(0.5), 1e-12);
}

// With the place of each camera.
TEST_F(CalibrationReader, ACamchainOfOurOwnIsReadBack) {
  v1::OpenStream stream;
  *stream.mutable_view() = read(kKalibr)[0];
  *stream.add_further_views() = stream.view();
  v1::RigidTransform& mount = *stream.mutable_further_views(0)->mutable_body_camera();
  mount.mutable_position()->set_x(0.1), mount.mutable_position()->set_z(-0.2);
  mount.mutable_rotation()->set_y(0.6), mount.mutable_rotation()->set_w(0.8);
  for (const CalibrationFile& file : calibrationFiles("a.csv", stream)) {
    if (!file.name.ends_with(".kalibr.yaml")) continue;
    const auto views = read(file.text);
    ASSERT_EQ(views.size(), 2u);
    EXPECT_NEAR(views[1].body_camera().position().x(), 0.1, 1e-12);
    EXPECT_NEAR(views[1].body_camera().position().z(), -0.2, 1e-12);
    EXPECT_NEAR(views[1].body_camera().rotation().y(), 0.6, 1e-12);
  }
}

TEST_F(CalibrationReader, AFaultNamesTheKeyAndWhatIsValid) {
  EXPECT_EQ(faultOf("a: 1\n"),
            ": is no calibration: there is neither cam0 (Kalibr) nor camera_matrix (OpenCV, ROS) nor K (a "
            "message of ROS)");
  EXPECT_EQ(faultOf("a: [1\n").substr(0, 3), ":2:");
  EXPECT_EQ(faultOf("[1, 2]\n"), " has no keys");
  const auto changed = [](std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
  };
  EXPECT_EQ(faultOf(changed(kKalibr, "equidistant", "fov")),
            ": cam0.distortion_model is 'fov'; there are: radtan, equidistant, none");
  EXPECT_EQ(faultOf(changed(kKalibr, "pinhole", "omni")), ": cam0.camera_model is 'omni'; there is: pinhole");
  EXPECT_EQ(faultOf(changed(kKalibr, ", 131.0", "")), ": cam0.intrinsics has 3 numbers; expected 4");
  EXPECT_EQ(faultOf(changed(kKalibr, "346", "wide")), ": cam0.resolution holds what is no number");
  EXPECT_EQ(faultOf(changed(kKalibr, "resolution", "size")), ": cam0.resolution is missing");
  EXPECT_EQ(faultOf(changed(kOpenCv, "0., 251.5", "0.5, 251.5")),
            ": camera_matrix is not of the form fx 0 cx 0 fy cy 0 0 1");
  EXPECT_EQ(faultOf(changed(kOpenCv, "0.003 ]", "0.003, 0.1 ]")),
            ": distortion_coefficients has more than k1 k2 p1 p2 k3");
  EXPECT_EQ(faultOf(kKalibr + "  T_cam_imu: [[2,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]\n"),
            ": cam0.T_cam_imu is no rigid transform of 4x4 numbers");
}

TEST_F(CalibrationReader, TheNoiseOfAnImuIsReadBack) {
  v1::OpenStream stream;
  *stream.mutable_view() = read(kKalibr)[0];
  v1::Truth& truth = *stream.add_truth();
  truth.set_name("imu");
  truth.mutable_imu()->set_rate_hz(400), truth.mutable_imu()->set_accelerometer_noise(0.01);
  for (const CalibrationFile& file : calibrationFiles("a.csv", stream))
    if (file.name.ends_with(".imu.yaml")) std::ofstream(path_) << file.text;
  const v1::Imu imu = readImuCalibration(path_);
  EXPECT_EQ(imu.rate_hz(), 400);
  EXPECT_EQ(imu.accelerometer_noise(), 0.01);
  EXPECT_GT(imu.gyroscope_walk(), 0) << "Kalibr refuses 0";
}

}  // namespace
}  // namespace saccade::client
