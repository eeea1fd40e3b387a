// Digests of files.
#pragma once

#include <string>
#include <vector>

#include "saccade/v1/dataset.pb.h"

namespace saccade::farm {

// BLAKE2b of 32 bytes, in hexadecimal. Throws std::system_error.
std::string digestOfFile(const std::string& file);

// All files below a folder, with their digests, in order of their names.
std::vector<v1::DataSetFile> filesOf(const std::string& folder);

// Of the names and digests of all files below a folder.
std::string digestOfFolder(const std::string& folder);

}  // namespace saccade::farm
