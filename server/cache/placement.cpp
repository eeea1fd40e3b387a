#include "cache/placement.h"

#include <limits>

namespace saccade {

void Placement::place(const SurfaceSamples& on, float finest_px) {
  constexpr int kMaxBins = 3, kMixed = 6;
  const std::size_t most = on.indexOf(0, on.height());
  points.clear(), points.reserve(most);
  row_ends.assign(1, 0);
  bins.resize(most * kMaxBins), bin_weights.resize(most * kMaxBins);
  least_level = std::numeric_limits<int>::max(), most_level = std::numeric_limits<int>::min();
  std::uint32_t next = 0;
  for (int y = 0; y < on.height(); ++y) {
    for (const SurfacePoint& s : on.row(y)) {
      if (s.kind == SurfaceKind::kNone) continue;
      const float level = std::log2(finest_px * s.footprint), floor = std::floor(level);
      const NormalBins normal(s.normal);
      const auto index = static_cast<std::uint32_t>(&s - &on.at(0, 0));
      points.push_back({index, static_cast<int>(floor), level - floor, s.position, next,
                        static_cast<std::uint32_t>(normal.count)});
      for (int b = 0; b < normal.count; ++b, ++next) {
        bins[next] = normal.bin[b] + (s.kind == SurfaceKind::kMixed ? kMixed : 0);
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
