// The text of each file of a calibration. See calibration.h.
#pragma once

#include <cstdint>
#include <string>

#include "saccade/v1/control.pb.h"

namespace saccade::client {

std::string cameraInfoYaml(const v1::OpenStream& stream, std::uint32_t view);
std::string kalibrYaml(const v1::OpenStream& stream);
std::string imuYaml(const v1::Truth& imu);
std::string dsecYaml(const v1::OpenStream& stream);

}  // namespace saccade::client
