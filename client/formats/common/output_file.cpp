#include "client/formats/common/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace saccade::client {
namespace {

int openFile(const std::string& path) {
  if (path == kStandardOutput) return dup(STDOUT_FILENO);
  return open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
}

// Of the whole file. It goes with the program that has it.
struct flock writeLock() {
  struct flock whole {};
  whole.l_type = F_WRLCK, whole.l_whence = SEEK_SET;
  return whole;
}

// Takes the lock, unless another has it.
bool isTaken(int file) {
  struct flock whole = writeLock();
  return fcntl(file, F_OFD_SETLK, &whole) != 0 && (errno == EAGAIN || errno == EACCES);
}

}  // namespace

bool isBeingWritten(const std::string& path) {
  const int file = open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK);  // a pipe has no lock
  if (file < 0) return false;
  struct flock found = writeLock();
  const bool told = fcntl(file, F_OFD_GETLK, &found) == 0;
  ::close(file);
  return told && found.l_type != F_UNLCK;
}

OutputFile::OutputFile(const std::string& path)
    : name_(path == kStandardOutput ? "standard output" : path), file_(openFile(path)) {
  if (file_ < 0) fail();
  if (path == kStandardOutput) return;
  try {
    begin();
  } catch (...) {
    ::close(file_);
    throw;
  }
}

void OutputFile::begin() {
  if (isTaken(file_))
    throw std::system_error(EWOULDBLOCK, std::generic_category(), name_ + ": another program is writing it");
  struct stat about {};
  if (fstat(file_, &about) == 0 && S_ISREG(about.st_mode) && ftruncate(file_, 0) != 0) fail();
}

OutputFile::~OutputFile() {
  if (file_ >= 0) ::close(file_);
}

void OutputFile::append(std::string_view bytes) {
  for (std::string_view rest = bytes; !rest.empty();) {
    const ssize_t written = write(file_, rest.data(), rest.size());
    if (written < 0 && errno != EINTR) takeBack();
    if (written > 0) rest.remove_prefix(static_cast<std::size_t>(written));
  }
  size_ += bytes.size();
}

void OutputFile::overwrite(std::uint64_t at, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = pwrite(file_, bytes.data(), bytes.size(), static_cast<off_t>(at));
    if (written < 0 && errno != EINTR) fail();
    if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written)), at += written;
  }
}

void OutputFile::close() {
  if (::close(std::exchange(file_, -1)) != 0) fail();
}

// Removes the part of an append() that was written.
void OutputFile::takeBack() {
  const int fault = errno;
  const bool is_file = lseek(file_, 0, SEEK_CUR) >= 0;
  if (!is_file || (ftruncate(file_, static_cast<off_t>(size_)) == 0 &&
                   lseek(file_, static_cast<off_t>(size_), SEEK_SET) >= 0))
    errno = fault;
  fail();
}

void OutputFile::fail() const {
  throw std::system_error(errno, std::generic_category(), name_);
}

}  // namespace saccade::client
