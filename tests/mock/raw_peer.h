// A TCP peer that speaks no ZeroMQ.
#pragma once

#include <chrono>
#include <cstddef>
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
  // The next bytes, at most so many; fewer where nothing comes for `patience`.
  std::string hear(std::size_t bytes, std::chrono::milliseconds patience);
  // Whether the other side has closed the connection, or does so within `limit`. Its output is thrown away.
  bool closed(std::chrono::milliseconds limit);

 private:
  int fd_;
};

}  // namespace saccade
