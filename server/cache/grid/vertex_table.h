// The vertices of a level, as consecutive indices in the order in which they are added.
#pragma once

#include <array>

#include "base/huge_pages.h"
#include "cache/lattice/index_table.h"
#include "cache/lattice/vertex_block.h"

namespace saccade {

class VertexTable {
 public:
  // Where a vertex is.
  struct Place {
    std::uint32_t block, cell;
  };
  // Finds places in frame `now`. The table must outlive it, and change through it alone.
  class Finder {
   public:
    Finder(VertexTable& table, std::uint32_t now) : table_(table), now_(now) {}
    // Brings what indexAt() needs closer. Call it some vertices ahead.
    Place find(VertexKey key) {
      const auto find = [this](VertexKey block) { return table_.blockAt(block, now_); };
      const Place place{memo_.of(key, find), cellOf(key)};
      __builtin_prefetch(&table_.indices_[place.block][place.cell]);
      return place;
    }

   private:
    VertexTable& table_;
    std::uint32_t now_;
    BlockMemo<std::uint32_t> memo_;
  };
  // Looks up vertices in a table that stays as it is, and outlives it.
  class Reader {
   public:
    explicit Reader(const VertexTable& table) : table_(&table) {}
    // The index of a vertex; kNone if there is none.
    std::uint32_t indexOf(VertexKey key) {
      const auto find = [this](VertexKey block) { return table_->blocks_.indexOf(block); };
      const std::uint32_t block = memo_.of(key, find);
      return block == kNone ? kNone : unmarked(table_->indices_[block][cellOf(key)]);
    }

   private:
    const VertexTable* table_;
    BlockMemo<std::uint32_t> memo_;
  };
  static constexpr std::uint32_t kNone = IndexTable::kNone;

  // The index of the vertex at a place, with kMarked if it is. A new one gets the next free index, marked.
  std::uint32_t markedIndexAt(Place place) {
    std::uint32_t& index = indices_[place.block][place.cell];
    if (index == kNone) index = size_++ | kMarked;
    return index;
  }
  std::uint32_t indexAt(Place place) { return unmarked(markedIndexAt(place)); }
  // A mark tells who looks up vertices to look closer. Tables have 2^31 vertices at most.
  static constexpr std::uint32_t kMarked = std::uint32_t{1} << 31;
  static std::uint32_t unmarked(std::uint32_t index) { return index == kNone ? kNone : index & ~kMarked; }
  void unmark(Place place) { indices_[place.block][place.cell] &= ~kMarked; }
  std::uint32_t size() const { return size_; }

  std::vector<VertexKey> keys() const;  // by index
  // The frame in which the block of each vertex was used last, by index.
  std::vector<std::uint32_t> lastUses() const;
  // Keeps the vertices whose `kept` is true, in their order.
  void keep(const std::vector<bool>& kept);

 private:
  using Block = std::array<std::uint32_t, kBlockCells>;

  std::uint32_t blockAt(VertexKey key, std::uint32_t now);

  IndexTable blocks_;
  HugeVector<Block> indices_;  // of the vertices of each block
  std::uint32_t size_ = 0;
};

}  // namespace saccade
