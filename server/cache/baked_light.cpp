#include "cache/baked_light.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace saccade {
namespace {

constexpr int kAhead = 4;            // points whose values are on their way from memory
constexpr float kLeastShare = 0.5f;  // of a point's weights, on known vertices of its coarser level
// From a level to the one below: a step is half as many cells there, and a quarter of the variance.
constexpr Octet kToFine{1, 1, 1, 1, 1, 0.25f, 0.25f, 0};

}  // namespace

BakedLight::BakedLight(const GridLevels& grid, const GridParams& params, const PoolHandle& pool)
    : params_(params) {
  grid.forEach([&](int l, const GridLevel&) {
    if (levels_.empty()) first_ = l;
    levels_.resize(l - first_);
    levels_.push_back(blendAtVertices(grid, l, params, pool));
    vertices_ += levels_.back().vertices();
  });
}

// Looks up the vertices of neighbouring points.
class BakedLight::Finder {
 public:
  explicit Finder(const BakedLight& baked) : baked_(baked) {}

  // Brings what add() needs closer.
  Found find(const SurfacePoint& point) {
    Found found;
    if (point.kind == SurfaceKind::kNone) return found;
    found.at = gridPoint(point, baked_.params_.finest_px);
    const NormalBins normal(point.normal);
    for (int slot = 0; slot < 2; ++slot) {
      const int l = found.at.level + slot, level = l - baked_.first_;
      if (level < 0 || level >= static_cast<int>(baked_.levels_.size())) continue;
      const Vec3d q = toDouble(found.at.position) * std::ldexp(1.0, -l);
      for (int b = 0; b < normal.count; ++b)
        add(Tetrahedron(q, vertexBin(normal.bin[b], point.kind)), normal.weight[b], readerOf(level),
            found.slots[slot]);
    }
    return found;
  }

 private:
  static void add(const Tetrahedron& corners, float weight, BakedLevel::Reader& reader, Taps& taps) {
    for (int c = 0; c < 4; ++c) {
      const Octet* light = reader.find(corners.key[c]);
      if (!light) continue;
      __builtin_prefetch(light);
      taps.tap[taps.count++] = {light, weight * corners.weight[c]};
    }
  }

  BakedLevel::Reader& readerOf(int level) {
    Entry& entry = entries_[static_cast<unsigned>(level) % entries_.size()];
    if (entry.level != level) {
      entry.level = level;
      entry.reader.emplace(baked_.levels_[level]);
    }
    return *entry.reader;
  }

  struct Entry {
    int level = -1;
    std::optional<BakedLevel::Reader> reader;
  };
  const BakedLight& baked_;
  std::array<Entry, 8> entries_;
};

SurfaceGrid::Time BakedLight::read(SurfaceSamples& on, const GBuffer& g, const PoolHandle& pool,
                                   GridEstimate& out) const {
  const int columns = on.columns(), height = on.height();
  return pool.run((height + kBandRows - 1) / kBandRows, [&](int band) {
    Finder finder(*this);
    std::array<Found, kAhead> found;
    for (int y = band * kBandRows; y < std::min((band + 1) * kBandRows, height); ++y) {
      for (const auto plane : {&out.i, &out.var_i, &out.var_step})
        std::fill_n(plane->row(y), plane->width(), 0.f);
      for (int column = 0; column < columns + kAhead; ++column) {
        const int ready = column - kAhead;
        if (ready >= 0) add(found[ready % kAhead], on.at(ready, y), g, ready / on.perPixel(), y, out);
        if (column < columns) found[column % kAhead] = finder.find(on.at(column, y));
      }
    }
  });
}

Octet BakedLight::Taps::sum() const {
  Octet sum{};
  for (int i = 0; i < count; ++i) sum += *tap[i].light * tap[i].weight;
  return sum;
}

void BakedLight::add(const Found& found, SurfacePoint& point, const GBuffer& g, int x, int y,
                     GridEstimate& out) const {
  const Octet fine = found.slots[0].sum(), coarse = found.slots[1].sum();
  point.baked = coarse[kKnown] >= kLeastShare;
  if (!point.baked) return;
  const float fraction = found.at.fraction, of_fine = 1 - fraction;
  const float of_coarse = (1 - of_fine * fine[kKnown]) / coarse[kKnown];  // also what no fine vertex knows
  const Octet v = fine * of_fine + coarse * kToFine * of_coarse;
  const float U = point.unoccluded, px = std::hypot(g.motion_x.at(x, y), g.motion_y.at(x, y));
  const float cells = px * std::exp2(fraction) / params_.finest_px, share2 = point.share * point.share;
  const auto variance = [U](float rest, float visibility) { return rest + U * U * visibility; };
  const float var_i = variance(v[kVarRest], v[kVarVisibility]);
  out.i.at(x, y) += point.share * (v[kRest] + U * v[kVisibility]);
  out.var_i.at(x, y) += share2 * var_i;
  out.var_step.at(x, y) +=
      share2 * std::min(2 * var_i, cells * cells * variance(v[kStepRest], v[kStepVisibility]));
}

}  // namespace saccade
