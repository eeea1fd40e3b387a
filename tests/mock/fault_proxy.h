// A TCP proxy that does to connections what networks do to them. It has one thread. A test says at any time
// what is to go wrong, and it goes wrong at a byte, not at a time.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <list>
#include <mutex>
#include <string>
#include <thread>

#include "stream/wake_fd.h"

namespace saccade {

struct Faults {
  enum class Cut { kNone, kReset, kTruncate, kHalfClose };

  std::chrono::milliseconds delay{0};  // of every byte, either way
  bool stall = false;                  // nothing passes, either way; connections stay open
  std::uint64_t bytes_per_s = 0;       // of each connection, towards the client; 0: no limit
  // The fate of a connection after `cut_after` bytes towards the client. RST goes to both ends; FIN goes to
  // both, and the rest is lost; or FIN goes to the client, whose own bytes still pass.
  Cut cut = Cut::kNone;
  std::uint64_t cut_after = 0;
};

class FaultProxy {
 public:
  // Listens on a free port of loopback for `target`, tcp://127.0.0.1:port.
  explicit FaultProxy(const std::string& target);
  ~FaultProxy();
  FaultProxy(const FaultProxy&) = delete;
  FaultProxy& operator=(const FaultProxy&) = delete;

  const std::string& endpoint() const { return endpoint_; }
  void set(const Faults& faults);             // for connections that there are, too
  void resetAll();                            // the connections there are
  int accepted() const { return accepted_; }  // connections, since the beginning
  int cuts() const { return cuts_; }          // of those, how many were cut
  std::string seen() const;                   // all bytes of both directions, as an eavesdropper has them

 private:
  struct Connection;
  struct Direction;
  void run();
  void accept();
  void turn(Connection& connection, const Faults& faults);
  void read(Direction& direction);
  static std::uint64_t allowance(Connection& connection, const Direction& direction, const Faults& faults);
  void write(Connection& connection, Direction& direction, const Faults& faults);
  void cut(Connection& connection, Faults::Cut how);

  const std::uint16_t target_port_;
  int listener_;
  std::string endpoint_;
  WakeFd wake_;
  mutable std::mutex mutex_;
  Faults faults_;
  std::string seen_;
  std::atomic<bool> stop_ = false, reset_all_ = false;
  std::atomic<int> accepted_ = 0, cuts_ = 0;
  std::list<Connection> connections_;  // the thread's
  std::thread thread_;
};

}  // namespace saccade
