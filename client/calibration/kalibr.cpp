// A camchain and the imu.yaml of Kalibr. The IMU has the axes and the clock of the body.
#include "client/calibration/formats.h"
#include "client/calibration/lens_yaml.h"
#include "client/calibration/rig.h"
#include "client/formats/common/ros_names.h"
#include "saccade/stream_views.h"

namespace saccade::client {
namespace {

constexpr double kNoNoise = 1e-6;  // stands for 0; a thousandth of the noise of good sensors, or less

}  // namespace

std::string kalibrYaml(const v1::OpenStream& stream) {
  const double scale = metresPerUnit(stream);
  std::string text;
  for (std::uint32_t n = 0; n < viewsOf(stream); ++n) {
    const Transform T_body_camera = bodyFromCamera(viewOf(stream, n), scale);
    text +=
        "cam" + std::to_string(n) + ":\n" + lensYaml(PinholeCamera(viewOf(stream, n)), "  ", "intrinsics");
    if (n > 0) {
      const Transform T_body_previous = bodyFromCamera(viewOf(stream, n - 1), scale);
      text += "  T_cn_cnm1:\n" + yamlRows("  ", relative(T_body_camera, T_body_previous));
    }
    if (imuOf(stream))
      text += "  T_cam_imu:\n" + yamlRows("  ", inverse(T_body_camera)) + "  timeshift_cam_imu: 0.0\n";
    text += "  rostopic: " + rosSpace(kRos1Space, n) + "/events\n";
  }
  return text;
}

std::string imuYaml(const v1::Truth& truth) {
  const v1::Imu& imu = truth.imu();
  const auto line = [](const char* name, double value) {
    return std::string(name) + ": " + yamlNumber(value) + "\n";
  };
  const auto noise = [&](const char* name, double value) {
    return value > 0 ? line(name, value) : line(name, kNoNoise) + "# in place of 0, which Kalibr refuses\n";
  };
  return noise("accelerometer_noise_density", imu.accelerometer_noise()) +
         noise("accelerometer_random_walk", imu.accelerometer_walk()) +
         noise("gyroscope_noise_density", imu.gyroscope_noise()) +
         noise("gyroscope_random_walk", imu.gyroscope_walk()) +
         "rostopic: " + rosSpace(kRos1Space, truth.view()) + "/imu\n" + line("update_rate", imu.rate_hz());
}

}  // namespace saccade::client
