#include "cache/baked_level.h"

#include "cache/index_table.h"

namespace saccade {

BakedLevel::BakedLevel(const std::vector<VertexKey>& keys, const std::vector<BakedVertex>& light)
    : light_(light.size()) {
  IndexTable order;  // of the blocks: that of their first vertices
  std::vector<Block> blocks;
  for (const VertexKey key : keys) {
    const std::uint32_t i = order.findOrAdd(blockOf(key), 0);
    if (i == blocks.size()) blocks.push_back({.key = blockOf(key)});
    blocks[i].cells |= std::uint64_t{1} << cellOf(key);
  }
  while ((std::size_t{1} << bits_) < 2 * blocks.size()) ++bits_;
  blocks_.resize(std::size_t{1} << bits_);
  for (const Block& block : blocks) blocks_[slotOf(block.key)] = block;
  std::uint32_t next = 0;
  for (Block& block : blocks_) block.first = next, next += std::popcount(block.cells);
  for (std::size_t v = 0; v < keys.size(); ++v)
    light_[blocks_[slotOf(blockOf(keys[v]))].indexOf(cellOf(keys[v]))] = light[v];
}

}  // namespace saccade
