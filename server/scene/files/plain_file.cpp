#include "scene/files/plain_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "scene/files/scene_error.h"

namespace saccade {
namespace {

class PlainFile {
 public:
  explicit PlainFile(const std::string& path)
      : path_(path), fd_(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {
    if (fd_ < 0) fail(std::strerror(errno));
    struct stat status {};
    const bool plain = fstat(fd_, &status) == 0 && S_ISREG(status.st_mode);
    size_ = static_cast<std::size_t>(status.st_size);
    if (plain) return;
    close(fd_);
    fail("is not a plain file");
  }
  ~PlainFile() { close(fd_); }
  PlainFile(const PlainFile&) = delete;
  PlainFile& operator=(const PlainFile&) = delete;

  std::size_t size() const { return size_; }

  std::string read(std::size_t count, std::size_t offset = 0) const {
    std::string bytes(count, '\0');
    for (std::size_t done = 0; done < count;) {
      const ssize_t got = ::pread(fd_, bytes.data() + done, count - done, static_cast<off_t>(offset + done));
      if (got < 0) fail(std::strerror(errno));
      if (got == 0) fail("became shorter while it was read");
      done += static_cast<std::size_t>(got);
    }
    return bytes;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw SceneError(path_ + ": cannot be read: " + what);
  }

  const std::string& path_;
  const int fd_;
  std::size_t size_;
};

}  // namespace

std::string readFile(const std::string& path, std::size_t max_bytes) {
  const PlainFile file(path);
  if (file.size() > max_bytes)
    throw SceneError(path + ": has more than " + std::to_string(max_bytes) + " bytes");
  return file.read(file.size());
}

std::string readBeginning(const std::string& path, std::size_t max_bytes) {
  const PlainFile file(path);
  return file.read(std::min(file.size(), max_bytes));
}

std::string readPart(const std::string& path, std::size_t offset, std::size_t bytes) {
  return PlainFile(path).read(bytes, offset);
}

std::size_t plainFileSize(const std::string& path) {
  return PlainFile(path).size();
}

}  // namespace saccade
