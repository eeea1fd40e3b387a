// A TCP port that waits for connections.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "client/dv/descriptor.h"

namespace saccade::client::dv {

struct Address {
  std::string host;
  std::uint16_t port = 0;  // 0: any free one
};

// Reads HOST:PORT; an IPv6 host stands in brackets. Throws std::invalid_argument.
Address parseAddress(const std::string& text);

struct Connection {
  Descriptor socket;  // does not block
  std::string peer;   // "127.0.0.1:40312"
};

class Listener {
 public:
  // Takes the port; connections are refused until listen(). Throws std::invalid_argument if it cannot be had.
  explicit Listener(const Address& address);

  void listen() const;  // throws std::system_error
  // The next connection; nothing if none waits.
  std::optional<Connection> accept() const;

  int descriptor() const { return socket_.number(); }
  const std::string& name() const { return name_; }  // "127.0.0.1:7777", with the port that was taken
  bool loopback() const { return loopback_; }        // whether only this machine reaches it

 private:
  Descriptor socket_;
  std::string name_;
  bool loopback_ = false;
};

}  // namespace saccade::client::dv
