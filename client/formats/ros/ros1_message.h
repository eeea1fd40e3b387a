// A message of ROS 1: numbers without padding, little-endian, and texts and arrays with their length before
// them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "client/formats/common/little_endian.h"

namespace saccade::client {

class Ros1Message {
 public:
  template <class T>
  void number(std::type_identity_t<T> value) {
    appendBytes<T>(bytes_, value);
  }
  void text(std::string_view value) { octets(value); }
  void octets(std::string_view bytes) {  // uint8[]
    number<std::uint32_t>(bytes.size());
    bytes_ += bytes;
  }
  const std::string& bytes() const { return bytes_; }
  void clear() { bytes_.clear(); }

 private:
  std::string bytes_;
};

}  // namespace saccade::client
