#include "client/formats/common/spool_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace saccade::client {
namespace {

constexpr std::uint64_t kBlock = 1 << 20;  // bytes

}  // namespace

SpoolFile::SpoolFile(const std::string& path) : path_(path) {
  std::string name = path + ".XXXXXX";
  file_ = mkostemp(name.data(), O_CLOEXEC);
  if (file_ < 0) fail(errno);
  unlink(name.c_str());
}

SpoolFile::~SpoolFile() {
  close(file_);
}

void SpoolFile::allocate(std::uint64_t size) {
  const int fault = posix_fallocate(file_, 0, static_cast<off_t>(size));
  if (fault != 0) fail(fault);
}

void SpoolFile::write(std::uint64_t at, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = pwrite(file_, bytes.data(), bytes.size(), static_cast<off_t>(at));
    if (written < 0 && errno != EINTR) fail(errno);
    if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written)), at += written;
  }
}

void SpoolFile::moveTo(OutputFile& target, std::uint64_t at, std::uint64_t size) {
  std::string block;
  cutTo(size);
  while (size > 0) {
    block.resize((size - 1) % kBlock + 1);
    size -= block.size();
    read(size, block);
    target.overwrite(at + size, block);
    cutTo(size);
  }
}

void SpoolFile::cutTo(std::uint64_t size) {
  if (ftruncate(file_, static_cast<off_t>(size)) != 0) fail(errno);
}

void SpoolFile::read(std::uint64_t at, std::string& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t got = pread(file_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(at + done));
    if (got == 0) fail(EIO);  // it is ours alone, and so has what was written
    if (got < 0 && errno != EINTR) fail(errno);
    if (got > 0) done += static_cast<std::size_t>(got);
  }
}

void SpoolFile::fail(int fault) const {
  throw std::system_error(fault, std::generic_category(), path_);
}

}  // namespace saccade::client
