#include "cache/baked_blend.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace saccade {
namespace {

constexpr int kChunk = 1024;         // vertices of a piece
constexpr float kLeastSamples = 2;   // around a vertex, in cells of about two pixels
constexpr float kAside = 1e-3f;      // of a cell: from a wall to one of its sides
constexpr float kSmallStep = 1e-3f;  // cells: the variance of steps so small grows with their square

// Looks up what a grid has around a vertex, on its level and those above.
class Surroundings {
 public:
  Surroundings(const GridLevels& grid, int l) : h_(std::ldexp(1., l)) {
    for (int slot = 0; slot < kSlots; ++slot)
      if (const GridLevel* level = grid.find(l + slot))
        levels_[slot] = level, readers_[slot].emplace(level->table);
  }
  // False where a wall stands between samples: a vertex of a bake has light of one side alone.
  bool lookFrom(VertexKey vertex) {
    place_ = Tetrahedron::placeOf(vertex), bin_ = Tetrahedron::binOf(vertex);
    point_ = toFloat(place_ * h_);
    const std::uint32_t v = readers_[0]->indexOf(vertex);
    const Cut* cut = levels_[0]->cuts.find(v);
    if (!cut) return true;
    const auto& light = levels_[0]->light;
    const bool near = light[v][0] > 0, far = light[cut->other][0] > 0;
    const float height = cut->heightOf(point_), aside = static_cast<float>(h_) * (far ? -kAside : kAside);
    if (far != (height < 0)) point_ = point_ + cut->normal * (aside - height);
    return !(near && far);
  }
  Quad light(int slot) { return gather(slot, &GridLevel::light); }
  Octet evidence(int slot) { return gather(slot, &GridLevel::evidence); }

 private:
  template <class V>
  V gather(int slot, HugeVector<V> GridLevel::*values) {
    V sum{};
    if (!levels_[slot]) return sum;
    const Tetrahedron corners(place_ * std::ldexp(1.0, -slot), bin_);
    for (int c = 0; c < 4; ++c) {
      if (corners.weight[c] == 0) continue;
      const std::uint32_t v = readers_[slot]->indexOf(corners.key[c]);
      if (v != VertexTable::kNone)
        sum += (levels_[slot]->*values)[levels_[slot]->cuts.of(v, point_)] * corners.weight[c];
    }
    return sum;
  }

  std::array<const GridLevel*, kSlots> levels_{};
  std::array<std::optional<VertexTable::Reader>, kSlots> readers_;
  double h_;     // edge of a cell of the vertex' level
  Vec3d place_;  // of the vertex, in such cells
  Vec3 point_;   // beside it, where its samples are
  int bin_ = 0;
};

BakedVertex blendAround(Surroundings& around, const GridParams& params, float scale) {
  const LevelBlend<float> blend([&](int slot) { return around.light(slot); },
                                [&](int slot) { return around.evidence(slot); }, 0, params.blend);
  if (blend.light[params.pixelSlot()][0] < kLeastSamples || blend.light[kTop - 1][0] == 0) return {};
  const auto step = [](const BlendedLight<float>& light) {
    return light.stepVariance(kSmallStep) / (kSmallStep * kSmallStep);
  };
  return {.known = true,
          .rest = scale * blend.rest.value,
          .visibility = blend.visibility.value,
          .var_rest = scale * scale * blend.rest.variance,
          .var_visibility = blend.visibility.variance,
          .step_rest = scale * scale * step(blend.rest),
          .step_visibility = step(blend.visibility)};
}

}  // namespace

BakedLevel blendAtVertices(const GridLevels& grid, int l, const BakedLevel& coarser, const GridParams& params,
                           float scale, const PoolHandle& pool) {
  std::vector<VertexKey> keys = grid[l].table.keys();
  std::erase_if(keys, isBehind);
  std::vector<BakedPair> light(keys.size());
  pool.run((static_cast<int>(keys.size()) + kChunk - 1) / kChunk, [&](int chunk) {
    Surroundings around(grid, l);
    const std::size_t begin = static_cast<std::size_t>(chunk) * kChunk;
    for (std::size_t v = begin; v < std::min(begin + kChunk, keys.size()); ++v) {
      const bool has_light = around.lookFrom(keys[v]);
      light[v] = {has_light ? blendAround(around, params, scale) : BakedVertex{}, coarser.between(keys[v])};
    }
  });
  std::size_t known = 0;
  for (std::size_t v = 0; v < keys.size(); ++v)
    if (light[v].fine().known || light[v].coarse().known) keys[known] = keys[v], light[known++] = light[v];
  keys.resize(known), light.resize(known);
  return {keys, light};
}

}  // namespace saccade
