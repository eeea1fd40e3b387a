// The readers of the table in pose_file.h.
#pragma once

#include <string>

namespace saccade::client {

std::string readKitti(const std::string& path, double rate_hz);
std::string readColmap(const std::string& path, double rate_hz);

}  // namespace saccade::client
