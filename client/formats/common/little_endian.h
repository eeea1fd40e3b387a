// Numbers as little-endian bytes, at the end of a string.
#pragma once

#include <bit>
#include <cstring>
#include <string>
#include <type_traits>

namespace saccade::client {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they lie in memory");

// Writes a number to `at`, and returns the place after it.
template <class T>
char* putNumber(char* at, std::type_identity_t<T> value) {
  static_assert(std::is_arithmetic_v<T>);
  std::memcpy(at, &value, sizeof(T));
  return at + sizeof(T);
}

// The type is always named, since it is the width in the file: appendBytes<std::uint32_t>(bytes, size).
template <class T>
void appendBytes(std::string& bytes, std::type_identity_t<T> value) {
  char buffer[sizeof(T)];
  putNumber<T>(buffer, value);
  bytes.append(buffer, sizeof(T));
}

}  // namespace saccade::client
