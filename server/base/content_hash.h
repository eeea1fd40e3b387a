// A hash of plain values.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#include "base/hash_rng.h"

namespace saccade {

// Add everything that the cached value depends on.
struct ContentHash {
  std::uint64_t value = 0;
  void bytes(const void* data, std::size_t size) {
    const auto* p = static_cast<const unsigned char*>(data);
    for (; size > 0; p += 8, size -= std::min<std::size_t>(size, 8)) {
      std::uint64_t word = 0;
      std::memcpy(&word, p, std::min<std::size_t>(size, 8));
      value = hashKey(value, word);
    }
  }
  template <class T>
  void add(const T& v) {
    static_assert(std::has_unique_object_representations_v<T> || std::is_floating_point_v<T> ||
                  sizeof(T) % 4 == 0);
    bytes(&v, sizeof v);
  }
  template <class T>
  void add(const std::vector<T>& v) {
    bytes(v.data(), v.size() * sizeof(T));
  }
};

}  // namespace saccade
