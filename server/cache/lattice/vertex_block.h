// Vertices in blocks of 4 x 4 x 4, within a level. Most vertices lie in the block of the one that was asked
// for before.
#pragma once

#include <immintrin.h>

#include <array>
#include <bit>

#include "cache/lattice/lattice.h"

namespace saccade {

inline constexpr std::uint32_t kBlockCells = 64;

inline VertexKey blockOf(VertexKey vertex) {
  using namespace vertex_bits;
  constexpr VertexKey kCell = VertexKey{3} << kX | VertexKey{3} << kY | VertexKey{3} << kZ;
  return vertex & ~kCell;
}
// Its place within the block.
inline std::uint32_t cellOf(VertexKey vertex) {
  using namespace vertex_bits;
  return static_cast<std::uint32_t>((vertex >> kX & 3) | (vertex >> kY & 3) << 2 | (vertex >> kZ & 3) << 4);
}
inline VertexKey vertexOf(VertexKey block, std::uint32_t cell) {
  using namespace vertex_bits;
  return block | VertexKey{cell & 3} << kX | VertexKey{cell >> 2 & 3} << kY | VertexKey{cell >> 4} << kZ;
}

// Blocks of a cube of 4 x 4 x 4 are a group.
inline constexpr int kGroupBits = 6;
namespace vertex_bits {
inline constexpr VertexKey kInGroup = VertexKey{12} << kX | VertexKey{12} << kY | VertexKey{12} << kZ;
}
inline VertexKey groupOf(VertexKey block) {
  return block & ~vertex_bits::kInGroup;
}
// Its place within the group, 0 to 63.
inline std::uint32_t placeInGroup(VertexKey block) {
  return static_cast<std::uint32_t>(_pext_u64(block, vertex_bits::kInGroup));
}

// Where a hash table of 2^bits slots, more than 64, keeps a key at first. The blocks of a group lie together:
// neighbours are wanted one after another.
inline std::size_t homeOf(VertexKey block, int bits) {
  const std::uint64_t hash = groupOf(block) * 0x9e3779b97f4a7c15ull;
  return hash >> (64 + kGroupBits - bits) << kGroupBits | placeInGroup(block);
}

// Remembers what was found for blocks.
template <class Found>
class BlockMemo {
 public:
  // Returned by find(block) for the block of a vertex.
  const Found& of(VertexKey vertex, const auto& find) {
    Known& known = known_[entryOf(vertex)];
    if (const VertexKey block = blockOf(vertex); known.block != block) known = {block, find(block)};
    return known.found;
  }

 private:
  struct Known {
    VertexKey block = 0;
    Found found{};
  };
  static std::size_t entryOf(VertexKey key) {
    using namespace vertex_bits;
    return (key >> (kX + 2) & 1) | (key >> (kY + 2) & 1) << 1 | (key >> (kZ + 2) & 1) << 2 |
           (key >> kBin & 31) << 3;
  }
  std::array<Known, 256> known_{};  // neighbours have entries of their own, and so have bins
};

}  // namespace saccade
