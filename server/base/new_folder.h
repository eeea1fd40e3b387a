// A folder that a program fills, and makes where it is absent.
#pragma once

#include <string>

namespace saccade {

// Why the folder cannot be filled; empty: it is there and can be written, or can be made. An empty path is no
// fault.
std::string newFolderFault(const std::string& path);

}  // namespace saccade
