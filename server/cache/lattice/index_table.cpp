#include "cache/lattice/index_table.h"

#include <utility>

namespace saccade {

std::uint32_t IndexTable::add(std::uint64_t key, std::uint32_t now) {
  if (2 * (size_ + 1ull) > slots_.size()) {
    HugeVector<Slot> old(2 * slots_.size());
    std::swap(old, slots_);
    ++bits_;
    for (const Slot& slot : old)
      if (slot.key != 0) slots_[find(slot.key)] = slot;
  }
  slots_[find(key)] = {key, size_, now};
  return size_++;
}

std::vector<std::uint64_t> IndexTable::keys() const {
  std::vector<std::uint64_t> keys(size_);
  for (const Slot& slot : slots_)
    if (slot.key != 0) keys[slot.index] = slot.key;
  return keys;
}

std::vector<std::uint32_t> IndexTable::lastUses() const {
  std::vector<std::uint32_t> uses(size_);
  for (const Slot& slot : slots_)
    if (slot.key != 0) uses[slot.index] = slot.used;
  return uses;
}

void IndexTable::keep(const std::vector<bool>& kept) {
  std::vector<Slot> by_index(size_);
  for (const Slot& slot : slots_)
    if (slot.key != 0) by_index[slot.index] = slot;
  slots_.assign(slots_.size(), Slot{});
  size_ = 0;
  for (const Slot& slot : by_index)
    if (kept[slot.index]) slots_[find(slot.key)] = {slot.key, size_++, slot.used};
}

}  // namespace saccade
