#include "cache/vertex_table.h"

#include <utility>

namespace saccade {

std::uint32_t VertexTable::add(std::uint64_t key) {
  if (2 * (size_ + 1ull) > slots_.size()) {
    std::vector<Slot> old(2 * slots_.size());
    std::swap(old, slots_);
    ++bits_;
    for (const Slot& slot : old)
      if (slot.key != 0) slots_[find(slot.key)] = slot;
  }
  slots_[find(key)] = {key, size_};
  return size_++;
}

}  // namespace saccade
