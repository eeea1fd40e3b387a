// The text of a file of poses, as it is sent.
#pragma once

#include <string>

namespace saccade::client {

// Throws std::invalid_argument with the option where the file cannot be read, is too long, or is no text.
std::string readPoseText(const std::string& option, const std::string& path);

}  // namespace saccade::client
