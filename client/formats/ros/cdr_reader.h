// Reads a message of ROS 2 in CDR, little-endian; see cdr.h.
#pragma once

#include <string_view>

#include "client/formats/common/byte_reader.h"

namespace saccade::client {

// Every call throws std::runtime_error for bytes that are no such message.
class CdrReader {
 public:
  explicit CdrReader(std::string_view message) : bytes_(message) {
    constexpr std::string_view kLittleEndian("\0\1", 2);
    const std::string_view head = bytes_.part(4);
    if (!head.starts_with(kLittleEndian))
      throw std::runtime_error("has a message that is not CDR, little-endian");
  }

  template <class T>
  T number() {
    bytes_.part((4 - bytes_.at()) % sizeof(T));
    return bytes_.number<T>();
  }
  std::string_view text() {  // ends with a zero
    const std::string_view text = octets();
    return text.substr(0, text.find('\0'));
  }
  std::string_view octets() { return bytes_.part(number<std::uint32_t>()); }  // uint8[]

 private:
  ByteReader bytes_;
};

}  // namespace saccade::client
