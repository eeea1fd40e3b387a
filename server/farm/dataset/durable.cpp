#include "farm/dataset/durable.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

namespace saccade::farm {

void flushFile(const std::string& path) {
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool flushed = file >= 0 && (fsync(file) == 0 || errno == EINVAL);  // some file systems cannot
  const int fault = errno;
  if (file >= 0) close(file);
  if (!flushed) throw std::system_error(fault, std::generic_category(), path);
}

void flushTree(const std::string& folder) {
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) flushFile(entry.path());
  flushFile(folder);
}

}  // namespace saccade::farm
