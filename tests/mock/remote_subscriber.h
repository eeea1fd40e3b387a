// A subscriber in a process of its own, for a test to stop or to kill.
#pragma once

#include <sys/types.h>

#include "mock/mock_subscriber.h"

namespace saccade {

class RemoteSubscriber {
 public:
  RemoteSubscriber();   // forks: to be made before the test has any other thread
  ~RemoteSubscriber();  // kills it
  RemoteSubscriber(const RemoteSubscriber&) = delete;
  RemoteSubscriber& operator=(const RemoteSubscriber&) = delete;

  // Whether it gives credit back for what it has received, and attaches anew when its connection is lost.
  enum class Refill { kNo, kYes };
  // Has it attach and give credit. Returns when it has got its first packet.
  void attach(const std::string& data_endpoint, const v1::StreamOpened& stream, std::uint64_t credit_bytes,
              Refill refill = Refill::kNo);
  // Of a stream with one sensor, at its END: what it has received, and what it was told had been dropped.
  // Adds a failure for each packet that is not as the schema says.
  Summary summary();
  void signal(int number);  // SIGSTOP: returns when it stands still

 private:
  int orders_, news_;  // ends of pipes
  pid_t pid_;
};

}  // namespace saccade
