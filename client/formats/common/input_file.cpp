#include "client/formats/common/input_file.h"

#include <cerrno>
#include <filesystem>
#include <system_error>

namespace saccade::client {

InputFile::InputFile(const std::string& path) : path_(path), file_(path, std::ios::binary) {
  if (!file_) throw std::system_error(errno, std::generic_category(), path);
  size_ = std::filesystem::file_size(path);
}

void InputFile::read(std::uint64_t at, std::uint64_t size, std::string& bytes) {
  bytes.resize(size);
  file_.seekg(static_cast<std::streamoff>(at));
  if (!file_.read(bytes.data(), static_cast<std::streamsize>(size)))
    throw std::system_error(errno ? errno : EIO, std::generic_category(), path_);
}

}  // namespace saccade::client
