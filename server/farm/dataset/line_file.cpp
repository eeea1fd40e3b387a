#include "farm/dataset/line_file.h"

#include <cerrno>
#include <system_error>

namespace saccade::farm {

LineFile::LineFile(const std::string& path) : path_(path), input_(path, std::ios::binary) {
  if (!input_) throw std::system_error(errno, std::generic_category(), path);
}

bool LineFile::next(std::string& line) {
  errno = 0;
  const bool found = bool(std::getline(input_, line));
  if (input_.bad() || errno == EISDIR)
    throw std::system_error(errno ? errno : EIO, std::generic_category(), path_);
  return found;
}

}  // namespace saccade::farm
