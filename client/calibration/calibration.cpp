#include "client/calibration/calibration.h"

#include "client/calibration/formats.h"
#include "client/calibration/rig.h"
#include "saccade/stream_views.h"

namespace saccade::client {

std::vector<CalibrationFile> calibrationFiles(const std::string& path, const v1::OpenStream& stream) {
  std::vector<CalibrationFile> files;
  for (std::uint32_t n = 0; n < viewsOf(stream); ++n) {
    const std::string camera = n == 0 ? "" : ".cam" + std::to_string(n);
    files.push_back({path + camera + ".camera_info.yaml", cameraInfoYaml(stream, n)});
  }
  files.push_back({path + ".kalibr.yaml", kalibrYaml(stream)});
  if (const v1::Truth* imu = imuOf(stream)) files.push_back({path + ".imu.yaml", imuYaml(*imu)});
  if (path.ends_with(".h5")) files.push_back({path + ".cam_to_cam.yaml", dsecYaml(stream)});
  return files;
}

std::string calibrationFault(const v1::OpenStream& stream) {
  for (std::uint32_t n = 0; n < viewsOf(stream); ++n) {
    const auto& k = viewOf(stream, n).distortion().coefficients();
    if (k.size() >= 5 && k[4] != 0) return "Kalibr and DSEC know no k3: give radtan four coefficients";
  }
  return {};
}

}  // namespace saccade::client
