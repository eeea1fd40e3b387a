#include "cache/baked_level.h"

namespace saccade {

BakedLevel::BakedLevel(const std::vector<VertexKey>& keys, const std::vector<Octet>& light)
    : light_(light.size()) {
  for (const VertexKey key : keys) {
    const std::uint32_t block = blocks_.findOrAdd(blockOf(key), 0);
    if (block == runs_.size()) runs_.emplace_back();
    runs_[block].cells |= std::uint64_t{1} << cellOf(key);
  }
  std::uint32_t next = 0;
  for (Run& run : runs_) run.first = next, next += std::popcount(run.cells);
  for (std::size_t v = 0; v < keys.size(); ++v)
    light_[runOf(blockOf(keys[v])).indexOf(cellOf(keys[v]))] = light[v];
}

}  // namespace saccade
