// Wakes a thread that sleeps in poll().
#pragma once

namespace saccade {

class WakeFd {
 public:
  WakeFd();  // throws std::system_error
  ~WakeFd();
  WakeFd(const WakeFd&) = delete;
  WakeFd& operator=(const WakeFd&) = delete;

  int fd() const { return fd_; }  // readable from wake() to clear()
  void wake();                    // from any thread
  void clear();

 private:
  int fd_;
};

}  // namespace saccade
