#include "stream/wake_fd.h"

#include <sys/eventfd.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace saccade {

WakeFd::WakeFd() : fd_(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {
  if (fd_ < 0) throw std::system_error(errno, std::generic_category(), "eventfd");
}

WakeFd::~WakeFd() {
  close(fd_);
}

// EAGAIN means that the counter is readable already.
void WakeFd::wake() {
  eventfd_write(fd_, 1);
}

void WakeFd::clear() {
  eventfd_t count;
  eventfd_read(fd_, &count);
}

}  // namespace saccade
