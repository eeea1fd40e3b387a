// The options for the body, its cameras and its IMU.
#include <gtest/gtest.h>

#include <fstream>

#include "client/options/imu_options.h"
#include "client/options/option_range.h"
#include "client/options/request_options.h"
#include "scratch_folder.h"

namespace saccade::client {
namespace {

struct Options {
  RequestOptions request;
  ImuOptions imu;
};

v1::OpenStream openStream(const std::string& line, const std::string& truth = "") {
  CLI::App app;
  Options options;
  addRequestOptions(app, options.request);
  addImuOptions(app, options.imu);
  app.parse("cornell-box --trajectory right " + line);
  v1::OpenStream open = makeOpenStream(options.request);
  if (!truth.empty()) open.add_truth()->set_name(truth);
  setImu(options.imu, options.request.rig.metres_per_unit, open);
  return open;
}

std::string faultOf(const std::string& line, const std::string& truth = "imu") {
  try {
    openStream(line, truth);
  } catch (const std::invalid_argument& fault) {
    return fault.what();
  } catch (const CLI::ParseError& fault) {
    return fault.what();
  }
  return {};
}

// A body turned by 90 degrees about z: x of the camera is y of the body.
TEST(RigOptions, FurtherViewsAreInTheAxesOfTheFirst) {
  const auto open = openStream("--body-camera 1,2,3,0,0,1,1 --further-view 0.1,0,0");
  EXPECT_EQ(open.view().body_camera().position().y(), 2);
  EXPECT_EQ(open.view().body_camera().rotation().z(), 1);
  const v1::Vector3& second = open.further_views(0).body_camera().position();
  EXPECT_NEAR(second.x(), 1, 1e-12);
  EXPECT_NEAR(second.y(), 2.1, 1e-12);
  EXPECT_NEAR(second.z(), 3, 1e-12);
}

TEST(RigOptions, TheImuIsSet) {
  const auto open = openStream("--imu rate_hz=400,gyroscope_noise=0.01 --metres-per-unit 0.5 --up z", "imu");
  const v1::Imu& imu = open.truth(0).imu();
  EXPECT_EQ(imu.rate_hz(), 400);
  EXPECT_EQ(imu.gyroscope_noise(), 0.01);
  EXPECT_EQ(imu.metres_per_unit(), 0.5);
  EXPECT_EQ(imu.gravity().z(), -9.81);
  EXPECT_EQ(imu.gravity().y(), 0);
  EXPECT_EQ(openStream("--up -y", "imu").truth(0).imu().gravity().y(), 9.81);
  EXPECT_EQ(openStream("--gravity 0,1.62,-0.5", "imu").truth(0).imu().gravity().y(), 1.62);
  EXPECT_FALSE(openStream("", "imu").truth(0).imu().has_gravity());
}

TEST(RigOptions, WhatCannotBeIsRefused) {
  EXPECT_EQ(faultOf("--imu rate_hz=1", "depth"), "--imu, --gravity and --up go with --truth imu");
  EXPECT_EQ(faultOf("--up z", "depth"), "--imu, --gravity and --up go with --truth imu");
  EXPECT_EQ(faultOf("--imu noise=1"),
            "--imu: 'noise=1' is neither FILE.yaml nor KEY=NUMBER, with KEY one of accelerometer_noise, "
            "accelerometer_walk, gyroscope_noise, gyroscope_walk, rate_hz");
  EXPECT_EQ(faultOf("--imu nosuch.yaml"), "--imu: 'nosuch.yaml' cannot be read");
  EXPECT_EQ(faultOf("--gravity 1,2"), "--gravity: '1,2' is not X,Y,Z");
  EXPECT_EQ(faultOf("--body-camera 1,2"), "--body-camera: '1,2' is not X,Y,Z or X,Y,Z,QX,QY,QZ,QW");
  EXPECT_EQ(faultOf("--metres-per-unit 0"), "--metres-per-unit: 0 is outside [1e-06, 1e+06]");
  EXPECT_NE(faultOf("--up w"), "");
}

class CalibrationOption : public testing::Test {
 protected:
  std::string write(const std::string& size) {
    std::ofstream(path_) << size << "camera_matrix: [50, 0, 15, 0, 51, 11, 0, 0, 1]\n";
    return "--calibration " + path_ + " ";
  }

  const ScratchFolder folder_;
  const std::string path_ = folder_.at("a.yaml");
};

TEST_F(CalibrationOption, GivesTheSizeToo) {
  const auto open = openStream(write("image_width: 32\nimage_height: 24\n"));
  EXPECT_EQ(open.view().width(), 32u);
  EXPECT_EQ(open.view().intrinsics().fy(), 51);
}

TEST_F(CalibrationOption, ASizeThatIsNotItsOwnIsRefused) {
  EXPECT_EQ(faultOf(write("image_width: 32\nimage_height: 24\n") + "--size 64x48"),
            "--size: '64x48': " + path_ + " is of 32x24 pixels");
  EXPECT_EQ(faultOf(write("")), "--calibration: " + path_ + " has no size: give --size");
  EXPECT_EQ(openStream(write("") + "--size 64x48").view().width(), 64u);
}

TEST(CameraOptions, IntrinsicsWithoutASizeSayWhichTheyTake) {
  EXPECT_EQ(sizeNote({.intrinsics = "1,1,1,1"}),
            "--intrinsics are taken for images of 240x180; --size says otherwise");
  EXPECT_EQ(sizeNote({.size = "32x24", .intrinsics = "1,1,1,1"}), "");
  EXPECT_EQ(sizeNote({}), "");
}

}  // namespace
}  // namespace saccade::client
