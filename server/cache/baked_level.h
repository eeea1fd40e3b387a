// Light that was computed ahead, of one level. It lies in memory by blocks.
#pragma once

#include <vector>

#include "base/huge_pages.h"
#include "cache/baked_vertex.h"
#include "cache/vertex_block.h"

namespace saccade {

class BakedLevel {
 public:
  BakedLevel() = default;
  // `light` is that of vertices with different keys.
  BakedLevel(const std::vector<VertexKey>& keys, const std::vector<BakedVertex>& light);

  std::size_t vertices() const { return light_.size(); }

  // Brings what find() needs closer.
  void prefetch(VertexKey vertex) const { __builtin_prefetch(&blocks_[homeOf(blockOf(vertex), bits_)]); }
  // The light at the corners of a tetrahedron, most of which share a block; nullptr where there is no such
  // vertex.
  std::array<const BakedVertex*, 4> find(const std::array<VertexKey, 4>& corners) const {
    std::array<const BakedVertex*, 4> found;
    const Block* block = blockAt(corners[0]);
    VertexKey of = blockOf(corners[0]);
    for (int c = 0; c < 4; ++c) {
      if (blockOf(corners[c]) != of) of = blockOf(corners[c]), block = blockAt(corners[c]);
      found[c] = find(block, corners[c]);
    }
    return found;
  }

 private:
  // The light at the vertices of a block lies in the order of their cells.
  struct alignas(32) Block {
    VertexKey key = 0;        // 0: a free slot
    std::uint64_t cells = 0;  // a bit for each vertex
    std::uint32_t first = 0;

    std::uint32_t indexOf(std::uint32_t cell) const {
      return first + std::popcount(cells & ((std::uint64_t{1} << cell) - 1));
    }
  };

  const Block* blockAt(VertexKey vertex) const { return &blocks_[slotOf(blockOf(vertex))]; }
  const BakedVertex* find(const Block* block, VertexKey vertex) const {
    const std::uint32_t cell = cellOf(vertex);
    return (block->cells >> cell & 1) != 0 ? &light_[block->indexOf(cell)] : nullptr;
  }

  std::size_t slotOf(VertexKey block) const {
    std::size_t i = homeOf(block, bits_);
    while (blocks_[i].key != block && blocks_[i].key != 0) i = (i + 1) & (blocks_.size() - 1);
    return i;
  }

  int bits_ = 7;
  HugeVector<Block> blocks_{std::size_t{1} << bits_};  // a hash table, at most half full
  HugeVector<BakedVertex> light_;
};

}  // namespace saccade
