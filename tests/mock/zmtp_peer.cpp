#include "mock/zmtp_peer.h"

#include <cstdint>

namespace saccade {
namespace {

std::string bigEndian(std::uint64_t value, int bytes) {
  std::string text;
  for (int i = bytes - 1; i >= 0; --i) text += static_cast<char>(value >> (8 * i));
  return text;
}

std::string frame(int flags, const std::string& body) {
  if (body.size() < 256) return bigEndian(flags, 1) + bigEndian(body.size(), 1) + body;
  return bigEndian(flags | 2, 1) + bigEndian(body.size(), 8) + body;
}

}  // namespace

std::string zmtpGreeting(int major) {
  std::string greeting = "\xff" + std::string(8, '\0') + "\x7f";
  greeting += bigEndian(static_cast<std::uint64_t>(major), 1) + bigEndian(1, 1) + "NULL";
  return greeting + std::string(64 - greeting.size(), '\0');
}

std::string zmtpCommand(const std::string& name, const std::string& body) {
  return frame(4, bigEndian(name.size(), 1) + name + body);
}

std::string zmtpPart(const std::string& bytes, bool more) {
  return frame(more ? 1 : 0, bytes);
}

std::string zmtpProperty(const std::string& name, const std::string& value) {
  return bigEndian(name.size(), 1) + name + bigEndian(value.size(), 4) + value;
}

ZmtpPeer::ZmtpPeer(const std::string& endpoint, const std::string& type, const std::string& identity)
    : peer_(endpoint) {
  constexpr std::size_t kGreeting = 64, kHead = 2;  // of a short frame: flags and length
  say(zmtpGreeting());
  peer_.hear(kGreeting);
  say(zmtpCommand("READY", zmtpProperty("Socket-Type", type) + zmtpProperty("Identity", identity)));
  const std::string head = peer_.hear(kHead);
  if (head.size() == kHead) peer_.hear(static_cast<unsigned char>(head[1]));
}

}  // namespace saccade
