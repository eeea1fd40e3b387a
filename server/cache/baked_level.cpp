#include "cache/baked_level.h"

#include <algorithm>

#include "cache/index_table.h"

namespace saccade {

void BakedLevel::forEachBlock(VertexKey vertex, const auto& f) {
  using namespace vertex_bits;
  constexpr std::array<int, 3> kShifts{kX, kY, kZ};
  constexpr VertexKey kMask = Tetrahedron::kAddressMask, kCells = kEdge - 1;
  // Along each axis a vertex at the begin of a block is also at the end of the one before.
  for (unsigned before = 0; before < 8; ++before) {
    VertexKey block = blockOf(vertex);
    std::uint32_t number = numberOf(vertex);
    bool at_begin = true;
    for (unsigned axis = 0; axis < 3; ++axis) {
      if ((before >> axis & 1) == 0) continue;
      const int shift = kShifts[axis];
      const VertexKey at = block >> shift & kMask;
      at_begin = at_begin && (vertex >> shift & 3) == 0;
      block = (block & ~(kMask << shift)) | ((at - kCells) & kMask) << shift;
      number += static_cast<std::uint32_t>(kCells) * kSteps[axis];
    }
    if (at_begin) f(block, number);
  }
}

BakedLevel::BakedLevel(const std::vector<VertexKey>& keys, const std::vector<BakedPair>& light)
    : vertices_(std::ranges::count_if(light, [](const BakedPair& both) { return both.fine.isKnown(); })) {
  IndexTable order;  // of the blocks: that of their first vertices
  std::vector<Block> blocks;
  for (const VertexKey key : keys)
    forEachBlock(key, [&](VertexKey block, std::uint32_t number) {
      const std::uint32_t i = order.findOrAdd(block, 0);
      if (i == blocks.size()) blocks.push_back({.key = block});
      blocks[i].vertices[number >> 6] |= std::uint64_t{1} << (number & 63);
    });
  while ((std::size_t{1} << bits_) < 4 * blocks.size()) ++bits_;
  blocks_.assign(std::size_t{1} << bits_, {});
  for (const Block& block : blocks) blocks_[slotOf(block.key)] = block;
  std::uint32_t next = kNothing + 1;
  for (Block& block : blocks_)
    for (std::size_t word = 0; word < 2; ++word)
      block.first[word] = next, next += static_cast<std::uint32_t>(std::popcount(block.vertices[word]));
  light_.resize(next);
  for (std::size_t v = 0; v < keys.size(); ++v)
    forEachBlock(keys[v], [&](VertexKey block, std::uint32_t number) {
      light_[blocks_[slotOf(block)].indexOf(number)] = light[v];
    });
}

BakedVertex BakedLevel::between(VertexKey finer) const {
  const Tetrahedron around(Tetrahedron::placeOf(finer) * 0.5, Tetrahedron::binOf(finer));
  std::size_t end = 3;  // half of the weights are there, or all at corner 0
  while (around.weight[end] == 0) --end;
  const BakedVertex &a = at(around.key[0]), &b = at(around.key[end]);
  return a.isKnown() && b.isKnown() ? meanOf(a, b) : BakedVertex{};
}

}  // namespace saccade
