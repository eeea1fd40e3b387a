// Upkeep of the grid: dropping vertices, and forgetting light.
#include <algorithm>

#include "cache/grid/surface_grid.h"

namespace saccade {
namespace {

// The number of frames that vertices may be unused so that at most `most` of them stay. It is at least 1, for
// those that the last frame uses.
std::uint32_t longestUnused(const GridLevels& levels, std::uint32_t now, std::size_t most) {
  std::vector<std::size_t> of_age(1);
  levels.forEach([&](int, const GridLevel& level) {
    for (const std::uint32_t used : level.table.lastUses()) {
      const std::uint32_t age = now - used;
      if (age >= of_age.size()) of_age.resize(age + 1);
      ++of_age[age];
    }
  });
  std::size_t kept = of_age[0] + (of_age.size() > 1 ? of_age[1] : 0);
  std::uint32_t age = 1;
  while (age + 1 < of_age.size() && kept + of_age[age + 1] <= most) kept += of_age[++age];
  return age;
}

template <class V>
void keepOnly(const std::vector<bool>& kept, HugeVector<V>& values) {
  std::size_t next = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (kept[i]) values[next++] = values[i];
  values.resize(next);
}

}  // namespace

std::size_t SurfaceGrid::vertices() const {
  std::size_t sum = 0;
  levels_.forEach([&](int, const GridLevel& level) { sum += level.table.size(); });
  return sum;
}

void SurfaceGrid::drop(Placement& prev) {
  const std::size_t before = vertices();
  const std::uint32_t longest = longestUnused(levels_, now_, params_.max_vertices / 2);
  levels_.forEach([&](int l, GridLevel& level) {
    std::vector<std::uint32_t> uses = level.table.lastUses();
    level.cuts.forEach([&](const Cut& cut) {
      std::uint32_t newest = 0;
      cut.forEachVertex([&](std::uint32_t v) { newest = std::max(newest, uses[v]); });
      cut.forEachVertex([&](std::uint32_t v) { uses[v] = newest; });
    });
    std::vector<bool> kept(uses.size());
    std::vector<std::uint32_t> moved(uses.size());
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < uses.size(); ++i)
      if ((kept[i] = now_ - uses[i] <= longest)) moved[i] = next++;
    level.table.keep(kept);
    keepOnly(kept, level.light);
    keepOnly(kept, level.evidence);
    level.cuts.keep(kept, moved);
    for (GridPoint& p : prev.points) {
      const int slot = l - p.level;
      if (!GridPoint::isSlot(slot)) continue;
      for (std::uint32_t t = p.first; t < p.first + p.count; ++t)
        for (std::uint32_t& v : prev.taps[slot][t].vertex) v = moved[v];
    }
  });
  dropped_ += before - vertices();
}

void SurfaceGrid::follow(const SurfaceGrid& other) {
  ++now_;
  if (dropped_ != other.dropped_) levels_ = {};
  dropped_ = other.dropped_;
  other.levels_.forEach([&](int l, const GridLevel& of) {
    levels_.makeAll(l, l);
    levels_[l].light.resize(of.table.size()), levels_[l].evidence.resize(of.table.size());
  });
}

void SurfaceGrid::forget() {
  levels_.forEach([](int, GridLevel& level) {
    std::fill(level.light.begin(), level.light.end(), Quad{});
    std::fill(level.evidence.begin(), level.evidence.end(), Octet{});
  });
}

}  // namespace saccade
