// Light that was computed ahead, of one level and of the next coarser one at the same vertices. Planes that
// cut the coarser cells into tetrahedra are among those that cut the finer cells. So each tetrahedron lies
// within a coarser one, and its corners tell the coarser light within exactly [ours].
//
// It lies in memory by blocks of 4 x 4 x 4 cells, and these by groups. A block holds the vertices at all
// corners of its cells, so that a tetrahedron needs one block: those at the border lie in several. Groups are
// few, so that their table stays at hand, and what a few pixels show lies close together. The variance of
// visibility near the edges of shadows lies apart: few blocks have any.
#pragma once

#include <vector>

#include "base/huge_pages.h"
#include "cache/bake/baked_vertex.h"
#include "cache/lattice/vertex_block.h"

namespace saccade {

class BakedLevel {
 public:
  BakedLevel() = default;
  // `light` is that of vertices with different keys, and `shadows` their BakedVertex::shadow; empty: all 0.
  BakedLevel(const std::vector<VertexKey>& keys, const std::vector<BakedPair>& light,
             const std::vector<float>& shadows = {});

  std::size_t vertices() const { return vertices_; }  // whose light on this level is known

  // The light at one of its vertices.
  const BakedPair& at(VertexKey vertex) const {
    return light_[blocks_[indexOf(blockOf(vertex))].indexOf(numberOf(vertex))];
  }
  // BakedVertex::shadow at one of its vertices.
  float shadowAt(VertexKey vertex) const {
    const Place place = placeOf(vertex);
    return isNearShadow(place) ? shadow(blocks_[place.block].indexOf(place.number)) : 0;
  }
  // That of this level at a vertex of the next finer level: an odd coordinate lies half way between two of
  // this one.
  BakedVertex between(VertexKey finer) const;

  // A tetrahedron, by the block and the number of its lowest corner.
  struct Place {
    std::uint32_t block, number;
  };
  // Brings what locate() needs closer.
  void prefetch(VertexKey lowest) const {
    __builtin_prefetch(&groups_[homeSlotOf(groupOf(blockOf(lowest)))]);
  }
  // Brings what find() needs closer.
  Place locate(VertexKey lowest) const {
    const Place place = placeOf(lowest);
    __builtin_prefetch(&blocks_[place.block]);
    return place;
  }
  // Where the light at the corners of a tetrahedron of an order is, see Tetrahedron::corners(); kNothing
  // where there is no such vertex.
  static constexpr std::uint32_t kNothing = 0;
  using Indices = std::array<std::uint32_t, 4>;
  Indices find(const Place& at, unsigned order) const {
    const Block& block = blocks_[at.block];
    const std::uint32_t first = at.number, last = first + kSteps[0] + kSteps[1] + kSteps[2];
    const auto [most, least] = Tetrahedron::axes(order);
    return {block.indexOf(first), block.indexOf(first + kSteps[most]), block.indexOf(last - kSteps[least]),
            block.indexOf(last)};
  }
  static bool lacks(const Indices& found) {
    const __m128i is = _mm_cmpeq_epi32(std::bit_cast<__m128i>(found), _mm_set1_epi32(kNothing));
    return _mm_testz_si128(is, is) == 0;
  }
  const BakedPair& operator[](std::uint32_t index) const { return light_[index]; }
  // Whether shadow() is above 0 anywhere in the block of a place, or anywhere.
  bool isNearShadow(const Place& at) const { return blocks_[at.block].isNearShadow(); }
  bool hasShadows() const { return !shadows_.empty(); }
  // BakedVertex::shadow, where that is so.
  float shadow(std::uint32_t index) const { return shadows_[index].value(); }

 private:
  static constexpr std::uint32_t kEdge = 5;  // vertices
  static constexpr std::array<std::uint32_t, 3> kSteps{1, kEdge, kEdge* kEdge};
  static constexpr std::uint32_t kNoBlock = 0;

  // The light at its vertices lies in the order of their numbers.
  struct Block {
    static constexpr std::uint64_t kNearShadow = std::uint64_t{1} << 63;  // beyond all numbers
    static_assert(kEdge * kEdge * kEdge < 127);

    std::array<std::uint64_t, 2> vertices = {};  // a bit for each, by number; and kNearShadow in the second
    std::array<std::uint32_t, 2> first = {};     // the index of the first vertex of each word

    bool isNearShadow() const { return (vertices[1] & kNearShadow) != 0; }
    std::uint32_t indexOf(std::uint32_t number) const {
      const std::uint64_t word = vertices[number >> 6], bit = std::uint64_t{1} << (number & 63);
      const auto index = first[number >> 6] + static_cast<std::uint32_t>(std::popcount(word & (bit - 1)));
      return (word & bit) != 0 ? index : kNothing;
    }
  };

  // Its blocks lie in the order of their places.
  struct Group {
    VertexKey key = 0;         // 0: a free slot
    std::uint64_t blocks = 0;  // a bit for each, by place
    std::uint32_t first = 0;   // the index of the first block
  };

  // Of the vertex that is the lowest corner of a cell of a block.
  static std::uint32_t numberOf(VertexKey vertex) {
    using namespace vertex_bits;
    return static_cast<std::uint32_t>((vertex >> kX & 3) * kSteps[0] + (vertex >> kY & 3) * kSteps[1] +
                                      (vertex >> kZ & 3) * kSteps[2]);
  }
  Place placeOf(VertexKey lowest) const { return {indexOf(blockOf(lowest)), numberOf(lowest)}; }
  // f(block, number) for each block that a vertex lies in.
  static void forEachBlock(VertexKey vertex, const auto& f);
  void makeGroups(const std::vector<VertexKey>& keys);
  void makeBlocks(const std::vector<VertexKey>& keys);
  void setShadows(const std::vector<VertexKey>& keys, const std::vector<float>& shadows);

  std::uint32_t indexOf(VertexKey block) const {
    const Group& group = groups_[slotOf(groupOf(block))];
    const std::uint64_t bit = std::uint64_t{1} << placeInGroup(block);
    const auto index = group.first + static_cast<std::uint32_t>(std::popcount(group.blocks & (bit - 1)));
    return (group.blocks & bit) != 0 ? index : kNoBlock;
  }
  std::size_t homeSlotOf(VertexKey group) const { return group * 0x9e3779b97f4a7c15ull >> (64 - bits_); }
  std::size_t slotOf(VertexKey group) const {
    std::size_t i = homeSlotOf(group);
    while (groups_[i].key != group && groups_[i].key != 0) i = (i + 1) & (groups_.size() - 1);
    return i;
  }

  int bits_ = 7;
  std::size_t vertices_ = 0;
  HugeVector<Group> groups_{std::size_t{1} << bits_};  // a hash table, at most a quarter full
  HugeVector<Block> blocks_{1};                        // the first is kNoBlock, and empty
  HugeVector<BakedPair> light_{1};                     // the first is kNothing
  HugeVector<VarianceByte> shadows_;                   // by the same index; empty: all 0
};

}  // namespace saccade
