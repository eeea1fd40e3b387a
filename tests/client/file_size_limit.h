// A disk that is full, for tests of writers.
#pragma once

#include <sys/resource.h>

#include <csignal>

namespace saccade::client {

// As on a full disk, no file gets longer than this while it lives.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, signal_before_);
  }

 private:
  rlimit before_;
  void (*signal_before_)(int) = std::signal(SIGXFSZ, SIG_IGN);
};

}  // namespace saccade::client
