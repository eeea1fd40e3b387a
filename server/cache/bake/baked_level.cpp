#include "cache/bake/baked_level.h"

#include <algorithm>

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

// Finds all groups, and which blocks they have.
void BakedLevel::makeGroups(const std::vector<VertexKey>& keys) {
  std::vector<VertexKey> groups;
  for (const VertexKey key : keys)
    forEachBlock(key, [&](VertexKey block, std::uint32_t) {
      if (groups.empty() || groups.back() != groupOf(block)) groups.push_back(groupOf(block));
    });
  std::ranges::sort(groups);
  groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
  while ((std::size_t{1} << bits_) < 4 * groups.size()) ++bits_;
  groups_.assign(std::size_t{1} << bits_, {});
  for (const VertexKey group : groups) groups_[slotOf(group)].key = group;
  for (const VertexKey key : keys)
    forEachBlock(key, [&](VertexKey block, std::uint32_t) {
      groups_[slotOf(groupOf(block))].blocks |= std::uint64_t{1} << placeInGroup(block);
    });
  std::uint32_t next = kNoBlock + 1;
  for (const VertexKey key : groups) {
    Group& group = groups_[slotOf(key)];
    group.first = next, next += static_cast<std::uint32_t>(std::popcount(group.blocks));
  }
  blocks_.resize(next);
}

// Finds which vertices the blocks have.
void BakedLevel::makeBlocks(const std::vector<VertexKey>& keys) {
  for (const VertexKey key : keys)
    forEachBlock(key, [&](VertexKey block, std::uint32_t number) {
      blocks_[indexOf(block)].vertices[number >> 6] |= std::uint64_t{1} << (number & 63);
    });
  std::uint32_t next = kNothing + 1;
  for (Block& block : blocks_)
    for (std::size_t word = 0; word < 2; ++word)
      block.first[word] = next, next += static_cast<std::uint32_t>(std::popcount(block.vertices[word]));
  light_.resize(next);
}

void BakedLevel::setShadows(const std::vector<VertexKey>& keys, const std::vector<float>& shadows) {
  if (std::ranges::all_of(shadows, [](float s) { return s == 0; })) return;
  shadows_.assign(light_.size(), VarianceByte(0));
  for (std::size_t v = 0; v < keys.size(); ++v) {
    if (shadows[v] == 0) continue;
    forEachBlock(keys[v], [&](VertexKey key, std::uint32_t number) {
      Block& block = blocks_[indexOf(key)];
      block.vertices[1] |= Block::kNearShadow;
      shadows_[block.indexOf(number)] = VarianceByte(shadows[v]);
    });
  }
}

BakedLevel::BakedLevel(const std::vector<VertexKey>& keys, const std::vector<BakedPair>& light,
                       const std::vector<float>& shadows)
    : vertices_(std::ranges::count_if(light, [](const BakedPair& both) { return both.fine().known; })) {
  makeGroups(keys);
  makeBlocks(keys);
  for (std::size_t v = 0; v < keys.size(); ++v)
    forEachBlock(keys[v], [&](VertexKey block, std::uint32_t number) {
      light_[blocks_[indexOf(block)].indexOf(number)] = light[v];
    });
  setShadows(keys, shadows);
}

BakedVertex BakedLevel::between(VertexKey finer) const {
  const Tetrahedron around(Tetrahedron::placeOf(finer) * 0.5, Tetrahedron::binOf(finer));
  std::size_t end = 3;  // half of the weights are there, or all at corner 0
  while (around.weight[end] == 0) --end;
  const auto fineAt = [&](VertexKey key) {
    BakedVertex fine = at(key).fine();
    fine.shadow = shadowAt(key);
    return fine;
  };
  const BakedVertex a = fineAt(around.key[0]), b = fineAt(around.key[end]);
  return a.known && b.known ? meanOf(a, b) : BakedVertex{};
}

}  // namespace saccade
