// A message of ROS 2 in CDR, little-endian. Each number lies at a multiple of its size, counted from the end
// of the four bytes at the front. Source: the DDS Interoperability Wire Protocol of the OMG, section 10.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "client/formats/common/little_endian.h"

namespace saccade::client {

class CdrMessage {
 public:
  template <class T>
  void number(std::type_identity_t<T> value) {
    bytes_.resize(bytes_.size() + (kHead.size() - bytes_.size()) % sizeof(T));
    appendBytes<T>(bytes_, value);
  }
  void text(std::string_view value) {
    number<std::uint32_t>(value.size() + 1);
    (bytes_ += value) += '\0';
  }
  void octets(std::string_view bytes) {  // uint8[]
    number<std::uint32_t>(bytes.size());
    bytes_ += bytes;
  }
  const std::string& bytes() const { return bytes_; }
  void clear() { bytes_ = kHead; }

 private:
  static constexpr std::string_view kHead{"\0\1\0\0", 4};
  std::string bytes_{kHead};
};

}  // namespace saccade::client
