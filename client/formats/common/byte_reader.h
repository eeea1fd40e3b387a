// Takes numbers and parts off bytes that a file has, little-endian, and never more than there are.
#pragma once

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <type_traits>

#include "client/formats/common/little_endian.h"

namespace saccade::client {

// Every call throws std::runtime_error where the bytes end too early.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  // The type is always named, since it is the width in the file.
  template <class T>
  T number() {
    static_assert(std::is_arithmetic_v<T>);
    T value;
    std::memcpy(&value, part(sizeof value).data(), sizeof value);
    return value;
  }
  std::string_view part(std::uint64_t size) {
    if (size > bytes_.size() - at_) throw std::runtime_error("ends too early");
    at_ += size;
    return bytes_.substr(at_ - size, size);
  }
  // With its size before it, as std::uint32_t.
  std::string_view sized() { return part(number<std::uint32_t>()); }

  std::size_t at() const { return at_; }  // bytes taken so far
  bool atEnd() const { return at_ == bytes_.size(); }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
};

}  // namespace saccade::client
