#include "cache/placement.h"

#include <limits>

namespace saccade {

void Placement::place(const SurfaceSamples& on, const GBuffer& g, float finest_px) {
  constexpr int kMaxBins = 3, kMixed = 6;
  const int width = g.z.width(), height = g.z.height();
  const std::size_t pixels = static_cast<std::size_t>(width) * height;
  points.resize(pixels), bins.resize(pixels * kMaxBins), bin_weights.resize(pixels * kMaxBins);
  least_level = std::numeric_limits<int>::max(), most_level = std::numeric_limits<int>::min();
  std::uint32_t next = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      GridPoint& point = points[static_cast<std::size_t>(y) * width + x];
      point = {};
      if (on.kind.at(x, y) == SurfaceKind::kNone) continue;
      const float level = std::log2(finest_px * on.footprint.at(x, y)), floor = std::floor(level);
      const NormalBins normal({g.nx.at(x, y), g.ny.at(x, y), g.nz.at(x, y)});
      point = {{on.x.at(x, y), on.y.at(x, y), on.z.at(x, y)},
               static_cast<int>(floor),
               level - floor,
               next,
               static_cast<std::uint32_t>(normal.count)};
      for (int b = 0; b < normal.count; ++b, ++next) {
        bins[next] = normal.bin[b] + (on.kind.at(x, y) == SurfaceKind::kMixed ? kMixed : 0);
        bin_weights[next] = normal.weight[b];
      }
      least_level = std::min(least_level, point.level);
      most_level = std::max(most_level, point.level + kSlots - 1);
    }
  }
  for (auto& slot : taps)
    if (slot.size() < next) slot.resize(next);
}

}  // namespace saccade
