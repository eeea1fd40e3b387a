#include "cache/lattice/placement.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "base/pool_handle.h"

namespace saccade {
namespace {

constexpr std::uint32_t kOneBits = 0x3f800000;  // of the float 1

}  // namespace

GridPoint gridPoint(const SurfacePlace& place, float cell_px) {
  const auto bits = std::bit_cast<std::uint32_t>(cell_px * place.footprint);
  const float scale = std::bit_cast<float>((bits & 0x7fffff) | kOneBits);
  return {.level = static_cast<int>(bits >> 23) - 127,
          .fraction = std::log2(scale),
          .scale = scale,
          .position = place.position};
}

void Placement::place(const SurfaceSamples& on, float cell_px) {
  constexpr int kMaxBins = 3;
  const std::size_t most = on.indexOf(0, on.height());
  clear();
  points.reserve(most), bins.reserve(most * kMaxBins), bin_weights.reserve(most * kMaxBins);
  if (!on.needPaths()) {
    band_ends.resize(static_cast<std::size_t>((on.height() + kBandRows - 1) / kBandRows) + 1);
    return;
  }
  const int square = kBandRows * on.perPixel();
  for (int y0 = 0; y0 < on.height(); y0 += kBandRows) {
    const int y1 = std::min(y0 + kBandRows, on.height());
    for (int x0 = 0; x0 < on.columns(); x0 += square) {
      const int x1 = std::min(x0 + square, on.columns());
      for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) {
          const std::size_t i = on.indexOf(x, y);
          if (on[i].kind != SurfaceKind::kNone && !on[i].baked)
            add(on.place(i), on[i].kind, static_cast<std::uint32_t>(i), cell_px);
        }
    }
    band_ends.push_back(points.size());
  }
  makeTaps();
}

void Placement::clear() {
  points.clear(), bins.clear(), bin_weights.clear();
  band_ends.assign(1, 0);
  least_level = std::numeric_limits<int>::max(), most_level = std::numeric_limits<int>::min();
}

void Placement::makeTaps() {
  for (auto& slot : taps)
    if (slot.size() < bins.size()) slot.resize(bins.size());
}

void Placement::add(const SurfacePlace& place, SurfaceKind kind, std::uint32_t index, float cell_px) {
  const NormalBins normal(place.normal);
  GridPoint& point = points.emplace_back(gridPoint(place, cell_px));
  point.index = index;
  point.first = static_cast<std::uint32_t>(bins.size()),
  point.count = static_cast<std::uint32_t>(normal.count);
  for (int b = 0; b < normal.count; ++b) {
    bins.push_back(vertexBin(normal.bin[b], kind));
    bin_weights.push_back(normal.weight[b]);
  }
  least_level = std::min(least_level, point.level);
  most_level = std::max(most_level, point.level + kSlots - 1);
}

}  // namespace saccade
