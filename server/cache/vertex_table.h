// A hash table from the keys of vertices to consecutive indices, in the order in which they are added.
#pragma once

#include <cstdint>
#include <vector>

namespace saccade {

class VertexTable {
 public:
  // Brings the place of a key closer: call it some keys ahead.
  void prefetch(std::uint64_t key) const { __builtin_prefetch(&slots_[home(key)]); }
  // The index of a vertex; the next free one if it is new. Key 0 is not valid.
  std::uint32_t findOrAdd(std::uint64_t key) {
    const Slot& slot = slots_[find(key)];
    return slot.key == key ? slot.index : add(key);
  }
  std::uint32_t size() const { return size_; }

 private:
  struct Slot {
    std::uint64_t key = 0;  // 0: free
    std::uint32_t index = 0;
  };
  static constexpr int kFirstBits = 10;

  std::size_t home(std::uint64_t key) const { return key * 0x9e3779b97f4a7c15ull >> (64 - bits_); }
  std::size_t find(std::uint64_t key) const {  // where it is, or belongs
    std::size_t i = home(key);
    while (slots_[i].key != 0 && slots_[i].key != key) i = (i + 1) & (slots_.size() - 1);
    return i;
  }
  std::uint32_t add(std::uint64_t key);

  int bits_ = kFirstBits;
  std::vector<Slot> slots_{std::size_t{1} << kFirstBits};  // at most half full
  std::uint32_t size_ = 0;
};

}  // namespace saccade
