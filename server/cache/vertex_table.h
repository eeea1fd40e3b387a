// The vertices of a level, as consecutive indices in the order in which they are added. They are found by
// blocks of 4 x 4 x 4: most vertices lie in the block of the one that was asked for before.
#pragma once

#include <array>

#include "cache/index_table.h"
#include "cache/lattice.h"

namespace saccade {

class VertexTable {
 public:
  // Where a vertex is.
  struct Place {
    std::uint32_t block, cell;
  };
  // Remembers blocks.
  class Memo {
   public:
    // find(key of a block) says where the block of a vertex is.
    std::uint32_t blockOf(VertexKey vertex, const auto& find) {
      Known& known = known_[entryOf(vertex)];
      if (const VertexKey key = keyOf(vertex); known.key != key) known = {key, find(key)};
      return known.block;
    }

   private:
    struct Known {
      VertexKey key = 0;
      std::uint32_t block = 0;
    };
    std::array<Known, 128> known_{};  // neighbours have entries of their own, and so have bins
  };
  // Finds places in frame `now`. The table must outlive it, and change through it alone.
  class Finder {
   public:
    Finder(VertexTable& table, std::uint32_t now) : table_(table), now_(now) {}
    // Brings what indexAt() needs closer. Call it some vertices ahead.
    Place find(VertexKey key) {
      const auto find = [this](VertexKey block) { return table_.blockAt(block, now_); };
      const Place place{memo_.blockOf(key, find), cellOf(key)};
      __builtin_prefetch(&table_.indices_[place.block][place.cell]);
      return place;
    }

   private:
    VertexTable& table_;
    std::uint32_t now_;
    Memo memo_;
  };
  // Looks up vertices in a table that stays as it is, and outlives it.
  class Reader {
   public:
    explicit Reader(const VertexTable& table) : table_(&table) {}
    // The index of a vertex; kNone if there is none.
    std::uint32_t indexOf(VertexKey key) {
      const auto find = [this](VertexKey block) { return table_->blocks_.indexOf(block); };
      const std::uint32_t block = memo_.blockOf(key, find);
      return block == kNone ? kNone : table_->indices_[block][cellOf(key)];
    }

   private:
    const VertexTable* table_;
    Memo memo_;
  };
  static constexpr std::uint32_t kNone = IndexTable::kNone;

  // The index of the vertex at a place; the next free index if it is new.
  std::uint32_t indexAt(Place place) {
    std::uint32_t& index = indices_[place.block][place.cell];
    if (index == kNone) index = size_++;
    return index;
  }
  std::uint32_t size() const { return size_; }

  std::vector<VertexKey> keys() const;  // by index
  // The frame in which the block of each vertex was used last, by index.
  std::vector<std::uint32_t> lastUses() const;
  // Keeps the vertices whose `kept` is true, in their order.
  void keep(const std::vector<bool>& kept);

 private:
  static constexpr int kX = 0, kY = 20, kZ = 40, kBin = 60;  // bits of VertexKey
  using Block = std::array<std::uint32_t, 64>;

  static VertexKey keyOf(VertexKey key) {  // of its block
    constexpr VertexKey kCell = VertexKey{3} << kX | VertexKey{3} << kY | VertexKey{3} << kZ;
    return key & ~kCell;
  }
  static std::uint32_t cellOf(VertexKey key) {
    return static_cast<std::uint32_t>((key >> kX & 3) | (key >> kY & 3) << 2 | (key >> kZ & 3) << 4);
  }
  static VertexKey keyOfCell(std::uint32_t cell) {  // the bits that keyOf() leaves out
    return VertexKey{cell & 3} << kX | VertexKey{cell >> 2 & 3} << kY | VertexKey{cell >> 4} << kZ;
  }
  static std::size_t entryOf(VertexKey key) {
    return (key >> (kX + 2) & 1) | (key >> (kY + 2) & 1) << 1 | (key >> (kZ + 2) & 1) << 2 | key >> kBin << 3;
  }
  std::uint32_t blockAt(VertexKey key, std::uint32_t now);

  IndexTable blocks_;
  std::vector<Block> indices_;  // of the vertices of each block
  std::uint32_t size_ = 0;
};

}  // namespace saccade
