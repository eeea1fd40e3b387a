// What a peer without keys says on a connection before its messages [ZMTP 3.0, rfc.zeromq.org/spec/23].
#pragma once

#include <cstdint>
#include <string>

namespace saccade::zmtp {

inline constexpr unsigned char kMore = 1, kLong = 2, kCommand = 4;

inline std::string greeting() {
  return std::string("\xFF\0\0\0\0\0\0\0\0\x7F\x03\0NULL", 16) + std::string(48, '\0');
}

inline std::string bigEndian(std::uint64_t value, int bytes) {
  std::string text;
  for (int i = bytes - 1; i >= 0; --i) text += static_cast<char>(value >> 8 * i & 0xFF);
  return text;
}

inline std::string frame(unsigned char flags, const std::string& body) {
  if (body.size() < 256) return std::string{static_cast<char>(flags), static_cast<char>(body.size())} + body;
  return static_cast<char>(flags | kLong) + bigEndian(body.size(), 8) + body;
}

inline std::string property(const std::string& name, const std::string& value) {
  return static_cast<char>(name.size()) + name + bigEndian(value.size(), 4) + value;
}

// `more`: further properties.
inline std::string ready(const std::string& socket_type, const std::string& more = {}) {
  return frame(kCommand, "\x05READY" + property("Socket-Type", socket_type) + more);
}

}  // namespace saccade::zmtp
