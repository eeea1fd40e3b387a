// The pieces that work on the grid is done in.
#pragma once

#include <algorithm>
#include <chrono>

#include "base/pool_handle.h"
#include "cache/lattice/placement.h"

namespace saccade {

// One piece for each level: vertices and sums are the same for any number of threads.
template <class F>
std::chrono::nanoseconds forEachLevel(const Placement& at, const PoolHandle& pool, const F& f) {
  if (at.empty()) return {};
  return pool.run(at.most_level - at.least_level + 1, [&](int i) { f(at.least_level + i); });
}

// f(index, point, slot) for the points that take part in level l, in order.
template <class F>
void forEachPointOf(const Placement& at, int l, const F& f) {
  for (std::size_t i = 0; i < at.points.size(); ++i) {
    const GridPoint& p = at.points[i];
    if (const int slot = l - p.level; GridPoint::isSlot(slot)) f(i, p, slot);
  }
}

// f(band, y0, y1) for each band of rows, y0 to y1 - 1; Placement::ofBand() has its points.
template <class F>
std::chrono::nanoseconds forEachBand(const SurfaceSamples& on, const PoolHandle& pool, const F& f) {
  return pool.run((on.height() + kBandRows - 1) / kBandRows, [&](int band) {
    f(band, band * kBandRows, std::min((band + 1) * kBandRows, on.height()));
  });
}

}  // namespace saccade
