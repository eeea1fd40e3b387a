// The first bytes of a peer without keys, before its messages [ZMTP 3.0, rfc.zeromq.org/spec/23].
#pragma once

#include <cstdint>
#include <string>

namespace saccade::zmtp {

inline constexpr unsigned char kMore = 1, kLong = 2, kCommand = 4;

inline std::string greeting(char version = 3) {
  return std::string("\xFF\0\0\0\0\0\0\0\0\x7F", 10) + version + std::string("\0NULL", 5) +
         std::string(48, '\0');
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

inline std::string part(const std::string& bytes, bool more = false) {
  return frame(more ? kMore : 0, bytes);
}

inline std::string command(const std::string& name, const std::string& body) {
  return frame(kCommand, static_cast<char>(name.size()) + name + body);
}

// `more`: further properties.
inline std::string ready(const std::string& socket_type, const std::string& more = {}) {
  return command("READY", property("Socket-Type", socket_type) + more);
}

}  // namespace saccade::zmtp
