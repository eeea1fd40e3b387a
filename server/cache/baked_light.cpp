#include "cache/baked_light.h"

#include <algorithm>
#include <cmath>

namespace saccade {
namespace {

constexpr float kLeastShare = 0.5f;  // of a point's weights, on known vertices of its coarser level
// From a level to the one below: a step is half as many cells there, and a quarter of the variance.
constexpr Octet kToFine{1, 1, 1, 0, 1, 1, 0.25f, 0.25f};

// f(x, y, index) for each point of a tile, by squares: neighbours in both directions share vertices.
void forEachPointBySquares(Tile tile, const SurfaceSamples& on, const auto& f) {
  constexpr int kSquare = 8;  // pixels
  for (int y0 = tile.y0; y0 < tile.y1; y0 += kSquare)
    for (int x0 = tile.x0; x0 < tile.x1; x0 += kSquare)
      for (int y = y0; y < std::min(y0 + kSquare, tile.y1); ++y)
        for (int x = x0; x < std::min(x0 + kSquare, tile.x1); ++x)
          for (int i = 0; i < on.perPixel(); ++i) f(x, y, on.indexOf(x * on.perPixel() + i, y));
}

}  // namespace

BakedLight::BakedLight(const GridLevels& grid, const GridParams& params, const PoolHandle& pool)
    : params_(params) {
  grid.forEach([&](int l, const GridLevel&) {
    auto& levels = levels_.levels;
    if (levels.empty()) levels_.first = l;
    levels.resize(l - levels_.first);
    levels.push_back(blendAtVertices(grid, l, params, pool));
    vertices_ += levels.back().vertices();
  });
}

void BakedLight::read(Tile tile, SurfaceSamples& on, const GBuffer& g, GridEstimate& out) const {
  std::array<BakedPoints, 3> batches;  // wanted, found and read in turn
  int batch = 0;
  const auto turn = [&] {
    batches[batch].want(levels_);
    batches[(batch + 2) % 3].find();
    batch = (batch + 1) % 3;
    BakedPoints& read = batches[batch];
    for (int i = 0; i < read.count(); ++i) add(read[i], read.sum(0, i), read.sum(1, i), on, g, out);
    read.clear();
  };
  for (int y = tile.y0; y < tile.y1; ++y)
    for (const auto plane : {&out.i, &out.var_i, &out.var_step})
      std::fill(plane->row(y) + tile.x0, plane->row(y) + tile.x1, 0.f);
  forEachPointBySquares(tile, on, [&](int x, int y, std::size_t index) {
    on[index].baked = false;
    if (on[index].kind != SurfaceKind::kNone) batches[batch].add(on, index, x, y, params_.finest_px);
    if (batches[batch].full()) turn();
  });
  for (int left = 0; left < 3; ++left) turn();
}

void BakedLight::add(const BakedPoints::Point& found, Octet fine, Octet coarse, SurfaceSamples& on,
                     const GBuffer& g, GridEstimate& out) const {
  const int x = found.x, y = found.y;
  SurfacePoint& point = on[found.at.index];
  point.baked = coarse[kKnown] >= kLeastShare;
  if (!point.baked) return;
  const float fraction = found.at.fraction, of_fine = 1 - fraction;
  const float of_coarse = (1 - of_fine * fine[kKnown]) / coarse[kKnown];  // also what no fine vertex knows
  const Octet v = fine * of_fine + coarse * kToFine * of_coarse;
  const float U = on.place(found.at.index).unoccluded, share2 = point.share * point.share;
  const float px = std::hypot(g.motion_x.at(x, y), g.motion_y.at(x, y));
  const float cells = px * found.at.scale / params_.finest_px;
  const auto variance = [U](float rest, float visibility) { return rest + U * U * visibility; };
  const float var_i = variance(v[kVarRest], v[kVarVisibility]);
  out.i.at(x, y) += point.share * (v[kRest] + U * v[kVisibility]);
  out.var_i.at(x, y) += share2 * var_i;
  out.var_step.at(x, y) +=
      share2 * std::min(2 * var_i, cells * cells * variance(v[kStepRest], v[kStepVisibility]));
}

}  // namespace saccade
