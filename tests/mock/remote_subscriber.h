// A subscriber in a process of its own, for a test to stop or to kill.
#pragma once

#include <sys/types.h>

#include "saccade/v1/control.pb.h"

namespace saccade {

class RemoteSubscriber {
 public:
  RemoteSubscriber();   // forks: to be made before the test has any other thread
  ~RemoteSubscriber();  // kills it
  RemoteSubscriber(const RemoteSubscriber&) = delete;
  RemoteSubscriber& operator=(const RemoteSubscriber&) = delete;

  // Has it attach and give credit once. Returns when it has got its first packet.
  void attach(const std::string& data_endpoint, const v1::StreamOpened& stream, std::uint64_t credit_bytes);
  void signal(int number);  // SIGSTOP: returns when it stands still

 private:
  int orders_, news_;  // ends of pipes
  pid_t pid_;
};

}  // namespace saccade
