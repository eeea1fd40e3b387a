#include "farm/plan/temporary_folder.h"

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace saccade::farm {

TemporaryFolder::TemporaryFolder() : path_(std::filesystem::temp_directory_path() / "saccade-farm-XXXXXX") {
  if (!mkdtemp(path_.data())) throw std::system_error(errno, std::generic_category(), path_);
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code gone;
  std::filesystem::remove_all(path_, gone);
}

}  // namespace saccade::farm
