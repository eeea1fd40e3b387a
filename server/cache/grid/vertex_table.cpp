#include "cache/grid/vertex_table.h"

#include <algorithm>

namespace saccade {

std::uint32_t VertexTable::blockAt(VertexKey key, std::uint32_t now) {
  const std::uint32_t block = blocks_.findOrAdd(key, now);
  if (block == indices_.size()) indices_.emplace_back().fill(kNone);
  return block;
}

std::vector<VertexKey> VertexTable::keys() const {
  const std::vector<VertexKey> of_blocks = blocks_.keys();
  std::vector<VertexKey> keys(size_);
  for (std::size_t b = 0; b < indices_.size(); ++b)
    for (std::uint32_t cell = 0; cell < indices_[b].size(); ++cell)
      if (const std::uint32_t index = unmarked(indices_[b][cell]); index != kNone)
        keys[index] = vertexOf(of_blocks[b], cell);
  return keys;
}

std::vector<std::uint32_t> VertexTable::lastUses() const {
  const std::vector<std::uint32_t> of_blocks = blocks_.lastUses();
  std::vector<std::uint32_t> uses(size_);
  for (std::size_t b = 0; b < indices_.size(); ++b)
    for (const std::uint32_t index : indices_[b])
      if (index != kNone) uses[unmarked(index)] = of_blocks[b];
  return uses;
}

void VertexTable::keep(const std::vector<bool>& kept) {
  std::vector<std::uint32_t> moved(size_, kNone);
  size_ = 0;
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (kept[i]) moved[i] = size_++;
  std::vector<bool> kept_blocks(indices_.size());
  std::size_t next = 0;
  for (std::size_t b = 0; b < indices_.size(); ++b) {
    for (std::uint32_t& index : indices_[b]) {
      if (index == kNone) continue;
      const std::uint32_t to = moved[unmarked(index)];
      index = to == kNone ? kNone : to | (index & kMarked);
    }
    kept_blocks[b] = std::any_of(indices_[b].begin(), indices_[b].end(), [](auto i) { return i != kNone; });
    if (kept_blocks[b]) indices_[next++] = indices_[b];
  }
  indices_.resize(next);
  blocks_.keep(kept_blocks);
}

}  // namespace saccade
