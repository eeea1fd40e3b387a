#include "cache/placement.h"

#include <limits>

namespace saccade {

GridPoint pointAt(const SurfaceSamples& on, int x, int y, float finest_px) {
  const float level = std::log2(finest_px * on.footprint.at(x, y)), floor = std::floor(level);
  return {.position = {on.x.at(x, y), on.y.at(x, y), on.z.at(x, y)},
          .level = static_cast<int>(floor),
          .fraction = level - floor};
}

void Placement::place(const SurfaceSamples& on, const GBuffer& g, float finest_px,
                      const Image<std::uint32_t>* left_out) {
  constexpr int kMaxBins = 3;
  const int width = g.z.width(), height = g.z.height();
  const std::size_t pixels = static_cast<std::size_t>(width) * height;
  points.resize(pixels), bins.resize(pixels * kMaxBins), bin_weights.resize(pixels * kMaxBins);
  least_level = std::numeric_limits<int>::max(), most_level = std::numeric_limits<int>::min();
  std::uint32_t next = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      GridPoint& point = points[static_cast<std::size_t>(y) * width + x];
      point = {};
      const SurfaceKind kind = on.kind.at(x, y);
      if (kind == SurfaceKind::kNone || (left_out && left_out->at(x, y) != 0)) continue;
      const NormalBins normal({g.nx.at(x, y), g.ny.at(x, y), g.nz.at(x, y)});
      point = pointAt(on, x, y, finest_px);
      point.first = next, point.count = static_cast<std::uint32_t>(normal.count);
      for (int b = 0; b < normal.count; ++b, ++next) {
        bins[next] = vertexBin(normal.bin[b], kind);
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
