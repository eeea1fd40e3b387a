#include "cache/bake/baked_light.h"

#include <algorithm>
#include <cmath>

#include "cache/grid/point_lanes.h"

namespace saccade {
namespace {

constexpr float kLeastShare = 0.5f;  // of a point's weights, on known vertices of its coarser level
// From a level to the one below: a step is half as many cells there, and a quarter of the variance.
constexpr float kStepToFine = 0.25f;

// The power of two that brings the brightest light of a grid to somewhat less than 2^7. Half floats then hold
// all that is brighter than a two millionth of it.
float scaleFor(const GridLevels& grid) {
  float brightest = 0;
  grid.forEach([&](int, const GridLevel& level) {
    for (const Quad& sum : level.light)
      if (sum[0] > 0) brightest = std::max(brightest, sum[1] / sum[0]);
  });
  return brightest > 0 ? std::ldexp(1.f, 6 - std::ilogb(brightest)) : 1;
}

// f(x, y, index) for each point of a tile, by squares within squares: neighbours in both directions share
// blocks of vertices.
void forEachPointBySquares(Tile tile, const SurfaceSamples& on, const auto& f) {
  constexpr unsigned kSquare = 8, kBitsOfX = 0x15, kBitsOfY = 0x2a;  // pixels; of a place along the curve
  for (int y0 = tile.y0; y0 < tile.y1; y0 += kSquare)
    for (int x0 = tile.x0; x0 < tile.x1; x0 += kSquare)
      for (unsigned place = 0; place < kSquare * kSquare; ++place) {
        const int x = x0 + static_cast<int>(_pext_u32(place, kBitsOfX));
        const int y = y0 + static_cast<int>(_pext_u32(place, kBitsOfY));
        if (x >= tile.x1 || y >= tile.y1) continue;
        for (int i = 0; i < on.perPixel(); ++i) f(x, y, on.indexOf(x * on.perPixel() + i, y));
      }
}

// A pixel whose light is known in part is not known.
void leavePartsOut(std::span<SurfacePoint> of_pixel, int x, int y, GridEstimate& out) {
  const auto isLive = [](const SurfacePoint& p) { return p.kind != SurfaceKind::kNone && !p.baked; };
  if (std::ranges::none_of(of_pixel, isLive)) return;
  for (SurfacePoint& p : of_pixel) p.baked = false;
  out.clear({x, y, x + 1, y + 1});
}

}  // namespace

BakedLight::BakedLight(const GridLevels& grid, const GridParams& params, const PoolHandle& pool)
    : params_(params), scale_(scaleFor(grid)) {
  int most = -1;
  grid.forEach([&](int l, const GridLevel&) {
    if (levels_.levels.empty()) levels_.first = l;
    most = l;
    levels_.levels.resize(l - levels_.first + 1);
  });
  for (int l = most; l >= levels_.first; --l) {
    if (!grid.find(l)) continue;
    BakedLevel& level = levels_.levels[l - levels_.first];
    level = blendAtVertices(grid, l, levels_.at(l + 1), params, scale_, pool);
    vertices_ += level.vertices();
  }
}

void BakedLight::read(Tile tile, SurfaceSamples& on, const GBuffer& g, GridEstimate& out) const {
  constexpr int kSteps = 4;
  std::array<BakedPoints, kSteps> batches;  // wanted, located, found and read in turn
  int batch = 0;
  const auto turn = [&] {
    batches[batch].want(levels_, params_.cell_px);
    batches[(batch + 3) % kSteps].locate();
    batches[(batch + 2) % kSteps].find();
    batch = (batch + 1) % kSteps;
    if (batches[batch].count() > 0) add(batches[batch], on, g, out);
    batches[batch].clear();
  };
  out.clear(tile);
  forEachPointBySquares(tile, on, [&](int x, int y, std::size_t index) {
    on[index].baked = false;
    if (on[index].kind == SurfaceKind::kNone) return;
    batches[batch].add({x, y, static_cast<std::uint32_t>(index)}, on.place(index), on[index].kind);
    if (batches[batch].full()) turn();
  });
  for (int left = 0; left < kSteps; ++left) turn();
  if (on.perPixel() == 1) return;
  for (int y = tile.y0; y < tile.y1; ++y)
    for (int x = tile.x0; x < tile.x1; ++x) leavePartsOut(on.of(x, y), x, y, out);
}

void BakedLight::add(const BakedPoints& points, SurfaceSamples& on, const GBuffer& g,
                     GridEstimate& out) const {
  using F = BakedPoints::F;
  LaneMemory<3> of_points;  // unoccluded light, share, and squared motion in pixels
  for (int i = 0; i < points.count(); ++i) {
    const auto [x, y, index] = points[i];
    const float mx = g.motion_x.at(x, y), my = g.motion_y.at(x, y);
    of_points.set(i, std::array{on.place(index).unoccluded, on[index].share, mx * mx + my * my});
  }
  const auto [U, share, px2] = of_points.lanes();
  const auto [means, variances] = points.light();
  const auto lanes = [](const Octet& column) { return F(__m256(column)); };
  const F of_fine = 1.f - points.fraction();
  const F fine_known = lanes(means[kKnown]), coarse_known = lanes(means[kOfCoarse + kKnown]);
  const auto known = coarse_known >= kLeastShare;
  const F of_coarse = (1.f - of_fine * fine_known) / coarse_known;  // also what no fine vertex knows
  const auto blend = [&](const auto& columns, int k, const F& of_coarse) {
    return F(lanes(columns[k]) * of_fine + lanes(columns[kOfCoarse + k]) * of_coarse);
  };
  const F visibility = blend(means, kVisibility, of_coarse);
  const F residual = blend(means, kResidual, of_coarse) / scale_;
  // Of `of_residual` and of what U is a factor of.
  const auto variance = [&, &U = U, &variances = variances](int of_residual, int of_visibility,
                                                            const F& of_coarse) {
    return F(blend(variances, of_residual, of_coarse) / (scale_ * scale_) +
             U * U * blend(variances, of_visibility, of_coarse));
  };
  const F cells = points.scale() / params_.cell_px;
  const F var_i = variance(kVarResidual, kVarVisibility, of_coarse);
  const F var_step =
      cells * cells * px2 * variance(kStepResidual, kStepVisibility, F(of_coarse * kStepToFine));
  LaneMemory<3> estimate;
  store(F(share * (residual + U * visibility)), estimate.values[0]);
  store(F(share * share * var_i), estimate.values[1]);
  store(F(share * share * min(F(2.f * var_i), var_step)), estimate.values[2]);
  forEachLane(lanesOf(known) & LaneSet::first(points.count()), [&](int i) {
    const auto [x, y, index] = points[i];
    on[index].baked = true;
    out.i.at(x, y) += estimate.values[0][i];
    out.var_i.at(x, y) += estimate.values[1][i];
    out.var_step.at(x, y) += estimate.values[2][i];
  });
}

}  // namespace saccade
