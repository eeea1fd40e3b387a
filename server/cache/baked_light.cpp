#include "cache/baked_light.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace saccade {
namespace {

constexpr int kChunk = 1024;         // vertices of a piece
constexpr float kLeastSamples = 8;   // around a vertex, in cells of about a pixel
constexpr float kLeastShare = 0.5f;  // of a point's weights, on vertices whose light is known
constexpr float kSmallStep = 1e-3f;  // cells: the variance of steps so small grows with their square

// Looks up what a grid has around a vertex, on its level and those above.
class Surroundings {
 public:
  Surroundings(const GridLevels& grid, int l) {
    for (int slot = 0; slot < kSlots; ++slot)
      if (const GridLevel* level = grid.find(l + slot))
        levels_[slot] = level, readers_[slot].emplace(level->table);
  }
  void lookFrom(VertexKey vertex) {
    place_ = Tetrahedron::placeOf(vertex), bin_ = Tetrahedron::binOf(vertex);
  }
  Quad light(int slot) { return gather(slot, &GridLevel::light); }
  Octet evidence(int slot) { return gather(slot, &GridLevel::evidence); }

 private:
  template <class V>
  V gather(int slot, std::vector<V> GridLevel::*values) {
    V sum{};
    if (!levels_[slot]) return sum;
    const Tetrahedron corners(place_ * std::ldexp(1.0, -slot), bin_);
    for (int c = 0; c < 4; ++c) {
      if (corners.weight[c] == 0) continue;
      const std::uint32_t v = readers_[slot]->indexOf(corners.key[c]);
      if (v != VertexTable::kNone) sum += (levels_[slot]->*values)[v] * corners.weight[c];
    }
    return sum;
  }

  std::array<const GridLevel*, kSlots> levels_{};
  std::array<std::optional<VertexTable::Reader>, kSlots> readers_;
  Vec3d place_;  // cells of the vertex' level
  int bin_ = 0;
};

Octet blendAround(Surroundings& around, const BlendParams& params) {
  const LevelBlend blend([&](int slot) { return around.light(slot); },
                         [&](int slot) { return around.evidence(slot); }, 0, params);
  if (blend.light[1][0] < kLeastSamples || blend.light[kTop - 1][0] == 0) return Octet{};
  const auto step = [](const BlendedLight& light) {
    return light.stepVariance(kSmallStep) / (kSmallStep * kSmallStep);
  };
  return Octet{1,
               blend.rest.value,
               blend.visibility.value,
               blend.rest.variance,
               blend.visibility.variance,
               step(blend.rest),
               step(blend.visibility)};
}

}  // namespace

BakedLight::BakedLight(GridLevels grid, const GridParams& params, const PoolHandle& pool) : params_(params) {
  grid.forEach([&](int l, const GridLevel& level) {
    if (levels_.empty()) first_ = l;
    levels_.resize(l - first_ + 1);
    std::vector<Octet>& light = levels_.back().light;
    light.resize(level.table.size());
    const std::vector<VertexKey> keys = level.table.keys();
    pool.run((static_cast<int>(keys.size()) + kChunk - 1) / kChunk, [&](int chunk) {
      Surroundings around(grid, l);
      const std::size_t begin = static_cast<std::size_t>(chunk) * kChunk;
      for (std::size_t v = begin; v < std::min(begin + kChunk, keys.size()); ++v) {
        around.lookFrom(keys[v]);
        light[v] = blendAround(around, params.blend);
      }
    });
    vertices_ += std::count_if(light.begin(), light.end(), [](const Octet& v) { return v[kKnown] > 0; });
  });
  grid.forEach([&](int l, GridLevel& level) { levels_[l - first_].table = std::move(level.table); });
}

// Looks up vertices of the levels that neighbouring pixels need.
class BakedLight::Readers {
 public:
  explicit Readers(const BakedLight& baked) : baked_(baked) {}
  VertexTable::Reader& of(int level) {
    Entry& entry = entries_[static_cast<unsigned>(level) % entries_.size()];
    if (entry.level != level) {
      entry.level = level;
      entry.reader.emplace(baked_.levels_[level].table);
    }
    return *entry.reader;
  }

 private:
  struct Entry {
    int level = -1;
    std::optional<VertexTable::Reader> reader;
  };
  const BakedLight& baked_;
  std::array<Entry, 8> entries_;
};

SurfaceGrid::Time BakedLight::read(const SurfaceSamples& on, const GBuffer& g, const PoolHandle& pool,
                                   GridEstimate& out, Image<std::uint32_t>& known) const {
  const int height = on.x.height();
  return pool.run((height + kBandRows - 1) / kBandRows, [&](int band) {
    Readers readers(*this);
    for (int y = band * kBandRows; y < std::min((band + 1) * kBandRows, height); ++y)
      for (int x = 0; x < on.x.width(); ++x) known.at(x, y) = readPixel(on, g, x, y, readers, out);
  });
}

bool BakedLight::readPixel(const SurfaceSamples& on, const GBuffer& g, int x, int y, Readers& readers,
                           GridEstimate& out) const {
  out.i.at(x, y) = out.var_i.at(x, y) = out.var_step.at(x, y) = 0;
  if (on.kind.at(x, y) == SurfaceKind::kNone) return false;
  const GridPoint p = pointAt(on, x, y, params_.finest_px);
  NormalBins normal({g.nx.at(x, y), g.ny.at(x, y), g.nz.at(x, y)});
  for (int b = 0; b < normal.count; ++b) normal.bin[b] = vertexBin(normal.bin[b], on.kind.at(x, y));
  const Octet fine = lightAt(p, normal, 0, readers), coarse = lightAt(p, normal, 1, readers);
  if (fine[kKnown] < kLeastShare || coarse[kKnown] < kLeastShare) return false;
  const Octet v = fine * ((1 - p.fraction) / fine[kKnown]) + coarse * (p.fraction / coarse[kKnown]);
  const float U = on.unoccluded.at(x, y), px = std::hypot(g.motion_x.at(x, y), g.motion_y.at(x, y));
  const float cells = px * std::exp2(p.fraction) / params_.finest_px;
  const auto variance = [U](float rest, float visibility) { return rest + U * U * visibility; };
  out.i.at(x, y) = v[kRest] + U * v[kVisibility];
  const float var_i = out.var_i.at(x, y) = variance(v[kVarRest], v[kVarVisibility]);
  out.var_step.at(x, y) = std::min(2 * var_i, cells * cells * variance(v[kStepRest], v[kStepVisibility]));
  return true;
}

Octet BakedLight::lightAt(const GridPoint& p, const NormalBins& normal, int slot, Readers& readers) const {
  Octet sum{};
  const int level = p.level + slot - first_;
  if (level < 0 || level >= static_cast<int>(levels_.size())) return sum;
  const Vec3d q = toDouble(p.position) * std::ldexp(1.0, -(p.level + slot));
  VertexTable::Reader& reader = readers.of(level);
  for (int b = 0; b < normal.count; ++b) {
    const Tetrahedron corners(q, normal.bin[b]);
    for (int c = 0; c < 4; ++c) {
      const std::uint32_t v = reader.indexOf(corners.key[c]);
      if (v != VertexTable::kNone) sum += levels_[level].light[v] * (corners.weight[c] * normal.weight[b]);
    }
  }
  return sum;
}

}  // namespace saccade
