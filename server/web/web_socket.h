// The server's end of a WebSocket: messages over a socket that never blocks.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>

#include "ops/http_upgrade.h"

struct wslay_event_context;

namespace saccade {

class WebSocket {
 public:
  static constexpr std::size_t kMaxText = 64 << 10;    // bytes; a longer message ends the connection
  static constexpr std::size_t kFullQueue = 1 << 20;   // bytes; with more waiting, nothing is read
  static constexpr std::size_t kFullCount = 1024;      // messages, likewise: pongs have no bytes
  static constexpr std::chrono::seconds kStall{5};     // a peer that takes nothing for so long is cut off
  static constexpr std::chrono::seconds kSilence{30};  // so is one that sends nothing, not even pongs
  static constexpr std::chrono::seconds kPing{10};

  using OnText = std::function<void(std::string_view)>;
  WebSocket(UpgradedSocket socket, OnText on_text);

  // The events to wait for, as poll() takes them.
  int fd() const { return socket_.fd; }
  short events() const;

  // Queues a message.
  void sendText(std::string_view text);
  void sendBinary(std::string_view bytes);
  // Says why it closes, as far as the peer takes it at once.
  void close(std::uint16_t code, std::string_view reason);

  // Reads and writes what is possible now. False: the connection is over, or its peer is stalled or silent.
  bool exchange();

  std::size_t queuedBytes() const;
  bool full() const;

 private:
  using Clock = std::chrono::steady_clock;
  struct Callbacks;
  void queue(std::uint8_t opcode, std::string_view bytes);
  bool alive();

  UpgradedSocket socket_;
  OnText on_text_;
  std::unique_ptr<wslay_event_context, void (*)(wslay_event_context*)> context_;
  std::size_t may_read_ = 0;  // bytes in this exchange
  Clock::time_point taken_, heard_, pinged_;
};

}  // namespace saccade
