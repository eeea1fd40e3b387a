// Files that survive a power cut.
#pragma once

#include <string>

namespace saccade::farm {

// Returns once the file, or the names in the folder, are on the disk. Throws std::system_error.
void flushFile(const std::string& path);
// All files and folders of a folder, and itself.
void flushTree(const std::string& folder);

}  // namespace saccade::farm
