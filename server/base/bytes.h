// Plain values as bytes, for files that the same kind of machine reads again.
#pragma once

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace saccade {

class ByteWriter {
 public:
  template <class T>
  void add(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  // With its size before it.
  template <class T, class Memory>
  void add(const std::vector<T, Memory>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    add<std::uint64_t>(values.size());
    bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
  }
  const std::string& bytes() const { return bytes_; }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

// Throws std::runtime_error where the bytes end too early.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : left_(bytes) {}
  template <class T>
  T get() {
    static_assert(std::is_trivially_copyable_v<T>);
    T value;
    std::memcpy(&value, next(1, sizeof value), sizeof value);
    return value;
  }
  template <class Vector>
  Vector getVector() {
    using T = typename Vector::value_type;
    const auto size = get<std::uint64_t>();
    const char* from = next(size, sizeof(T));
    Vector values(size);
    if (size > 0) std::memcpy(values.data(), from, size * sizeof(T));
    return values;
  }
  std::string_view left() const { return left_; }

 private:
  const char* next(std::uint64_t count, std::size_t size) {
    if (count > left_.size() / size) throw std::runtime_error("the file ends too early");
    const char* from = left_.data();
    left_.remove_prefix(count * size);
    return from;
  }
  std::string_view left_;
};

}  // namespace saccade
