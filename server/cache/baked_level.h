// Light that was computed ahead, of one level. It lies in memory by blocks.
#pragma once

#include <vector>

#include "cache/index_table.h"
#include "cache/lanes.h"
#include "cache/vertex_block.h"

namespace saccade {

class BakedLevel {
  // The light at the vertices of a block lies in the order of their cells.
  struct Run {
    std::uint64_t cells = 0;  // a bit for each vertex
    std::uint32_t first = 0;

    bool has(std::uint32_t cell) const { return (cells >> cell & 1) != 0; }
    std::uint32_t indexOf(std::uint32_t cell) const {
      return first + std::popcount(cells & ((std::uint64_t{1} << cell) - 1));
    }
  };

 public:
  BakedLevel() = default;
  // `light` is that of vertices with different keys.
  BakedLevel(const std::vector<VertexKey>& keys, const std::vector<Octet>& light);

  std::size_t vertices() const { return light_.size(); }

  // Looks up vertices of the level, which must outlive it.
  class Reader {
   public:
    explicit Reader(const BakedLevel& level) : level_(&level) {}
    // nullptr if there is no such vertex.
    const Octet* find(VertexKey key) {
      const Run run = memo_.of(key, [this](VertexKey block) { return level_->runOf(block); });
      return run.has(cellOf(key)) ? &level_->light_[run.indexOf(cellOf(key))] : nullptr;
    }

   private:
    const BakedLevel* level_;
    BlockMemo<Run> memo_;
  };

 private:
  Run runOf(VertexKey block) const {
    const std::uint32_t i = blocks_.indexOf(block);
    return i == IndexTable::kNone ? Run{} : runs_[i];
  }

  IndexTable blocks_;
  std::vector<Run> runs_;  // by block
  std::vector<Octet> light_;
};

}  // namespace saccade
