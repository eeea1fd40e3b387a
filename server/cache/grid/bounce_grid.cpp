#include "cache/grid/bounce_grid.h"

#include <algorithm>
#include <cmath>

namespace saccade {
namespace {

constexpr float kEdgePixels = 16;   // of the largest cells
constexpr float kLeastSamples = 8;  // that make light known
constexpr float kMostSamples = 1024;

// 18 bits of a coordinate. Cells that share an address are 2^18 cells apart, and so at different distances.
std::uint64_t address(float coordinate, float edge) {
  constexpr std::int64_t kRange = 1 << 18;
  return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(coordinate / edge)) + kRange / 2) &
         (kRange - 1);
}

// 1 to 6: the axis that a normal is nearest to, and its side.
std::uint64_t sideOf(Vec3 n) {
  const float x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
  if (x >= y && x >= z) return n.x < 0 ? 1 : 2;
  if (y >= z) return n.y < 0 ? 3 : 4;
  return n.z < 0 ? 5 : 6;
}

}  // namespace

BounceCell::BounceCell(Vec3 p, Vec3 normal, float pixel) {
  const float level = std::floor(std::log2(kEdgePixels * pixel));
  edge = std::exp2(level);
  const auto level_bits = static_cast<std::uint64_t>(static_cast<std::int64_t>(level) + 64) & 127;
  key = address(p.x, edge) | address(p.y, edge) << 18 | address(p.z, edge) << 36 | sideOf(normal) << 54 |
        level_bits << 57;
}

std::optional<BounceGrid::Known> BounceGrid::find(const BounceCell& cell) const {
  const std::uint32_t i = table_.indexOf(cell.key);
  if (i == IndexTable::kNone || light_[i][0] < kLeastSamples) return {};
  const Quad& sum = light_[i];
  return Known{Rgb{sum[1], sum[2], sum[3]} * (1 / sum[0]), sum[0] >= kMostSamples};
}

void BounceGrid::add(const SurfaceSamples& on) {
  for (std::size_t index = 0; index < on.indexOf(0, on.height()); ++index) {
    if (on[index].paths == 0) continue;
    const BounceSample& s = on.light(index).bounce;
    if (s.cell == 0) continue;
    if (cells() >= max_cells_ && table_.indexOf(s.cell) == IndexTable::kNone) continue;
    const std::uint32_t i = table_.findOrAdd(s.cell, 0);
    light_.resize(table_.size());
    if (light_[i][0] < kMostSamples) light_[i] += Quad{1, s.light.x, s.light.y, s.light.z};
  }
}

bool BounceGrid::restore(const std::vector<std::uint64_t>& keys, const std::vector<Quad>& light) {
  light_ = light;
  for (std::uint32_t i = 0; i < keys.size(); ++i)
    if (keys[i] == 0 || table_.findOrAdd(keys[i], 0) != i) return false;
  return true;
}

void BounceGrid::forget() {
  std::fill(light_.begin(), light_.end(), Quad{});
}

}  // namespace saccade
