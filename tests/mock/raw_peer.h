// A TCP peer that speaks no ZeroMQ.
#pragma once

#include <chrono>
#include <string>

namespace saccade {

class RawPeer {
 public:
  explicit RawPeer(const std::string& endpoint);  // of loopback
  ~RawPeer();
  RawPeer(RawPeer&& other) noexcept;
  RawPeer(const RawPeer&) = delete;

  bool connected() const { return fd_ >= 0; }
  void say(const std::string& bytes);
  std::string hear(std::size_t count);  // fewer bytes where the other side closes
  // Whether the other side has closed the connection, or does so within `limit`. What it says is thrown away.
  bool closed(std::chrono::milliseconds limit);

 private:
  int fd_;
};

}  // namespace saccade
