#include "cache/bake/baked_blend.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "cache/grid/ray_visibility.h"

namespace saccade {
namespace {

constexpr int kChunk = 1024;         // vertices of a piece
constexpr float kLeastSamples = 2;   // around a vertex, in cells of about two pixels
constexpr float kAlike = 0.1f;       // of the light on both sides of a wall
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
  void lookFrom(VertexKey vertex) {
    place_ = Tetrahedron::placeOf(vertex), bin_ = Tetrahedron::binOf(vertex);
    point_ = toFloat(place_ * h_);
    cut_ = levels_[0]->cuts.find(readers_[0]->indexOf(vertex));
  }
  // A bit for each side of walls that has samples; for all sides, if none has any.
  std::uint32_t sides() const {
    if (!cut_) return 1;
    const std::uint32_t all = (1u << cut_->planes.sides()) - 1;
    std::uint32_t sampled = 0;
    for (std::uint32_t side = 0; side < cut_->planes.sides(); ++side)
      sampled |= std::uint32_t{levels_[0]->light[cut_->vertices[side]][0] > 0} << side;
    return sampled != 0 ? sampled : all;
  }
  // Selects the side that light() and evidence() read.
  void goTo(std::uint32_t side) {
    if (!cut_) return;
    const float aside = static_cast<float>(h_) * kAside;
    for (const CutPlane& plane : cut_->planes) {
      const bool behind = side & 1;
      if (plane.isBehind(point_) != behind)
        point_ = point_ + plane.normal * ((behind ? -aside : aside) - plane.heightOf(point_));
      side >>= 1;
    }
  }
  Quad light(int slot) { return gather(slot, &GridLevel::light); }
  Octet evidence(int slot) { return gather(slot, &GridLevel::evidence); }

 private:
  template <class V>
  V gather(int slot, HugeVector<V> GridLevel::*values) {
    V sum{};
    if (!levels_[slot]) return sum;
    const Tetrahedron corners(place_ * double{powerOfTwo(-slot)}, bin_);
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
  double h_;                  // edge of a cell of the vertex' level
  Vec3d place_;               // of the vertex, in such cells
  const Cut* cut_ = nullptr;  // of it
  Vec3 point_;                // beside the vertex, on one side
  int bin_ = 0;
};

// Light is U V at least. So detail can be visible only where it exceeds a part of V.
float shadowOf(const Octet& evidence, const BlendedLight<float>& visibility) {
  const float detail = evidence[7] > 0 ? visibilityDetail(evidence) : 0;
  const float least = kLeastNearShadow * kLeastShadowContrast * visibility.value;
  return detail > std::max(kLeastShadow, least * least) ? detail + visibility.variance : 0;
}

BakedVertex blendAround(Surroundings& around, const GridParams& params, float scale) {
  const LevelBlend<float> blend([&](int slot) { return around.light(slot); },
                                [&](int slot) { return around.evidence(slot); }, 0, params.blend);
  if (blend.light[params.pixelSlot()][0] < kLeastSamples || blend.light[kTop - 1][0] == 0) return {};
  const auto step = [](const BlendedLight<float>& light) {
    return light.stepVariance(kSmallStep) / (kSmallStep * kSmallStep);
  };
  return {.known = true,
          .residual = scale * blend.residual.value,
          .visibility = blend.visibility.value,
          .var_residual = scale * scale * blend.residual.variance,
          .var_visibility = blend.visibility.variance,
          .step_residual = scale * scale * step(blend.residual),
          .step_visibility = step(blend.visibility),
          .shadow = shadowOf(around.evidence(params.pixelSlot() + kPoolSteps), blend.visibility)};
}

bool isAlike(const BakedVertex& a, const BakedVertex& b) {
  return a.known && b.known &&
         std::abs(a.residual - b.residual) <= kAlike * std::max(a.residual, b.residual) &&
         std::abs(a.visibility - b.visibility) <= kAlike;
}

// A vertex of a bake has one light. Where walls stand, all sides must have the same.
BakedVertex blendSides(Surroundings& around, const GridParams& params, float scale) {
  std::optional<BakedVertex> all;
  bool alike = true;
  forEachLane({around.sides()}, [&](int side) {
    around.goTo(side);
    const BakedVertex one = blendAround(around, params, scale);
    if (all)
      alike = alike && isAlike(*all, one);
    else
      all = one;
  });
  return alike ? *all : BakedVertex{};
}

}  // namespace

BakedLevel blendAtVertices(const GridLevels& grid, int l, const BakedLevel& coarser, const GridParams& params,
                           float scale, const PoolHandle& pool) {
  std::vector<VertexKey> keys = grid[l].table.keys();
  std::erase_if(keys, isOnFurtherSide);
  std::vector<BakedPair> light(keys.size());
  std::vector<float> shadows(keys.size());
  pool.run((static_cast<int>(keys.size()) + kChunk - 1) / kChunk, [&](int chunk) {
    Surroundings around(grid, l);
    const std::size_t begin = static_cast<std::size_t>(chunk) * kChunk;
    for (std::size_t v = begin; v < std::min(begin + kChunk, keys.size()); ++v) {
      around.lookFrom(keys[v]);
      const BakedVertex fine = blendSides(around, params, scale), coarse = coarser.between(keys[v]);
      light[v] = {fine, coarse};
      shadows[v] = fine.known ? fine.shadow : coarse.shadow;
    }
  });
  std::size_t known = 0;
  for (std::size_t v = 0; v < keys.size(); ++v)
    if (light[v].fine().known || light[v].coarse().known)
      keys[known] = keys[v], light[known] = light[v], shadows[known++] = shadows[v];
  keys.resize(known), light.resize(known), shadows.resize(known);
  return {keys, light, shadows};
}

}  // namespace saccade
