#include "cache/placement.h"

#include <bit>
#include <cmath>
#include <limits>

namespace saccade {
namespace {

constexpr std::uint32_t kOneBits = 0x3f800000;  // of the float 1

}  // namespace

GridPoint gridPoint(const SurfacePoint& point, float finest_px) {
  const auto bits = std::bit_cast<std::uint32_t>(finest_px * point.footprint);
  const float scale = std::bit_cast<float>((bits & 0x7fffff) | kOneBits);
  return {.level = static_cast<int>(bits >> 23) - 127,
          .fraction = std::log2(scale),
          .scale = scale,
          .position = point.position};
}

void Placement::place(const SurfaceSamples& on, float finest_px) {
  constexpr int kMaxBins = 3;
  const std::size_t most = on.indexOf(0, on.height());
  points.clear(), points.reserve(most);
  row_ends.assign(1, 0);
  bins.resize(most * kMaxBins), bin_weights.resize(most * kMaxBins);
  least_level = std::numeric_limits<int>::max(), most_level = std::numeric_limits<int>::min();
  std::uint32_t next = 0;
  for (int y = 0; y < on.height(); ++y) {
    for (const SurfacePoint& s : on.row(y)) {
      if (s.kind == SurfaceKind::kNone || s.baked) continue;
      const NormalBins normal(s.normal);
      GridPoint point = gridPoint(s, finest_px);
      point.index = static_cast<std::uint32_t>(&s - &on.at(0, 0));
      point.first = next, point.count = static_cast<std::uint32_t>(normal.count);
      points.push_back(point);
      for (int b = 0; b < normal.count; ++b, ++next) {
        bins[next] = vertexBin(normal.bin[b], s.kind);
        bin_weights[next] = normal.weight[b];
      }
      least_level = std::min(least_level, points.back().level);
      most_level = std::max(most_level, points.back().level + kSlots - 1);
    }
    row_ends.push_back(points.size());
  }
  for (auto& slot : taps)
    if (slot.size() < next) slot.resize(next);
}

}  // namespace saccade
