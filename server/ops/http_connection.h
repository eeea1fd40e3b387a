// One connection to the HTTP server: reads one request, answers it, closes. Never waits.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

#include "ops/http_response.h"

namespace saccade {

class HttpConnection {
 public:
  using Clock = std::chrono::steady_clock;

  // `socket` does not block; it is closed at the end.
  HttpConnection(int socket, Clock::time_point until) : socket_(socket), until_(until) {}
  ~HttpConnection();
  HttpConnection(const HttpConnection&) = delete;
  HttpConnection& operator=(const HttpConnection&) = delete;

  int socket() const { return socket_; }
  short awaits() const;  // what poll() is to wait for
  // Reads and writes what can be. False: the connection is over, or its time is up.
  bool goOn(const HttpPages& pages);

 private:
  enum class State { kReading, kWriting, kLeaving };
  bool read(const HttpPages& pages);
  bool write();
  bool leave() const;

  const int socket_;
  const Clock::time_point until_;
  State state_ = State::kReading;
  std::string head_, response_;
  std::size_t written_ = 0;
};

}  // namespace saccade
