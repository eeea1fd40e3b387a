#include "feed/temporary_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <utility>

namespace saccade {
namespace {

namespace fs = std::filesystem;

// A name lasts over a power cut once its folder is on the disk, too.
bool syncFolder(const fs::path& folder) {
  const int file = open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  const bool done = file >= 0 && fsync(file) == 0;
  if (file >= 0) close(file);
  return done;
}

}  // namespace

TemporaryFile::TemporaryFile(const std::string& path) : path_(path) {
  while (!create()) {
  }
  check(fchmod(file_, 0644) == 0);
}

// False where the file was taken for one that is left, before it had its lock.
bool TemporaryFile::create() {
  if (file_ >= 0) close(std::exchange(file_, -1));
  name_ = path_ + ".XXXXXX";
  file_ = mkostemp(name_.data(), O_CLOEXEC);
  check(file_ >= 0);
  flock(file_, LOCK_EX);  // where the disk has no locks, nothing is removed
  struct stat now {};
  return fstat(file_, &now) != 0 || now.st_nlink > 0;
}

TemporaryFile::~TemporaryFile() {
  if (!name_.empty()) unlink(name_.c_str());
  if (file_ >= 0) close(file_);
}

void TemporaryFile::write(const void* data, std::size_t size) {
  const char* next = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t written = ::write(file_, next, size);
    check(written > 0 || errno == EINTR);
    if (written > 0) next += written, size -= static_cast<std::size_t>(written);
  }
}

void TemporaryFile::keep() {
  check(fsync(file_) == 0);
  check(rename(name_.c_str(), path_.c_str()) == 0);
  name_.clear();
  check(syncFolder(fs::path(path_).parent_path()));
}

void TemporaryFile::check(bool done) const {
  if (!done) throw std::system_error(errno, std::generic_category(), path_);
}

void removeLeftover(const std::string& name) {
  const int file = open(name.c_str(), O_RDWR | O_NONBLOCK | O_NOFOLLOW | O_CLOEXEC);
  if (file < 0) return;
  if (flock(file, LOCK_EX | LOCK_NB) == 0) unlink(name.c_str());
  close(file);
}

}  // namespace saccade
