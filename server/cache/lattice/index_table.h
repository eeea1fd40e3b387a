// A hash table from keys to consecutive indices, in the order in which they are added.
#pragma once

#include <cstdint>
#include <vector>

#include "base/huge_pages.h"
#include "cache/lattice/vertex_block.h"

namespace saccade {

class IndexTable {
 public:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  // The index of a key that is used in frame `now`; the next free index if it is new. Key 0 is not valid.
  std::uint32_t findOrAdd(std::uint64_t key, std::uint32_t now) {
    Slot& slot = slots_[find(key)];
    if (slot.key != key) return add(key, now);
    slot.used = now;
    return slot.index;
  }
  // The index of a key, kNone if there is none.
  std::uint32_t indexOf(std::uint64_t key) const {
    const Slot& slot = slots_[find(key)];
    return slot.key == key ? slot.index : kNone;
  }
  std::uint32_t size() const { return size_; }

  std::vector<std::uint64_t> keys() const;  // by index
  // The frame in which each key was used last, by index.
  std::vector<std::uint32_t> lastUses() const;
  // Keeps the keys whose `kept` is true, in their order.
  void keep(const std::vector<bool>& kept);

 private:
  struct Slot {
    std::uint64_t key = 0;  // 0: free
    std::uint32_t index = 0, used = 0;
  };
  static constexpr int kFirstBits = 10;

  std::size_t home(std::uint64_t key) const { return homeOf(key, bits_); }
  std::size_t find(std::uint64_t key) const {  // where it is, or belongs
    std::size_t i = home(key);
    while (slots_[i].key != 0 && slots_[i].key != key) i = (i + 1) & (slots_.size() - 1);
    return i;
  }
  std::uint32_t add(std::uint64_t key, std::uint32_t now);

  int bits_ = kFirstBits;
  HugeVector<Slot> slots_{std::size_t{1} << kFirstBits};  // at most half full
  std::uint32_t size_ = 0;
};

}  // namespace saccade
