// Vertices in blocks of 4 x 4 x 4, within a level: most vertices lie in the block of the one that was asked
// for before.
#pragma once

#include <array>
#include <bit>

#include "cache/lattice.h"

namespace saccade {

inline constexpr std::uint32_t kBlockCells = 64;

namespace vertex_bits {
inline constexpr int kX = 0, kY = 20, kZ = 40, kBin = 60;  // of VertexKey
}

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

// The bits of a block's key in which the blocks of a cube of 4 x 4 x 4 differ.
inline constexpr int kNeighbourBits = 6;
inline constexpr VertexKey kNeighbours = [] {
  using namespace vertex_bits;
  return VertexKey{12} << kX | VertexKey{12} << kY | VertexKey{12} << kZ;
}();

// Remembers what was found for blocks.
template <class Found>
class BlockMemo {
 public:
  // What find(block) returns for the block of a vertex.
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
    return (key >> (kX + 2) & 1) | (key >> (kY + 2) & 1) << 1 | (key >> (kZ + 2) & 1) << 2 | key >> kBin << 3;
  }
  std::array<Known, 128> known_{};  // neighbours have entries of their own, and so have bins
};

}  // namespace saccade
