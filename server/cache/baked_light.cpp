#include "cache/baked_light.h"

#include <algorithm>
#include <cmath>

namespace saccade {
namespace {

constexpr float kLeastShare = 0.5f;  // of a point's weights, on known vertices of its coarser level
// From a level to the one below: a step is half as many cells there, and a quarter of the variance.
constexpr Octet kToFine{1, 1, 1, 0, 1, 1, 0.25f, 0.25f};

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

SurfaceGrid::Time BakedLight::read(SurfaceSamples& on, const GBuffer& g, const PoolHandle& pool,
                                   GridEstimate& out) const {
  const int columns = on.columns(), height = on.height();
  return pool.run((height + kBandRows - 1) / kBandRows, [&](int band) {
    std::array<BakedPoints, 3> batches;  // wanted, found and read in turn
    int batch = 0;
    const auto turn = [&] {
      batches[batch].want(levels_);
      batches[(batch + 2) % 3].find();
      batch = (batch + 1) % 3;
      add(batches[batch], on.perPixel(), g, out);
      batches[batch].clear();
    };
    const int y0 = band * kBandRows, y1 = std::min(y0 + kBandRows, height);
    for (int y = y0; y < y1; ++y)
      for (const auto plane : {&out.i, &out.var_i, &out.var_step})
        std::fill_n(plane->row(y), plane->width(), 0.f);
    // By squares: neighbours in both directions share blocks of vertices.
    for (int x = 0; x < columns; x += kBandRows) {
      for (int y = y0; y < y1; ++y) {
        for (int column = x; column < std::min(x + kBandRows, columns); ++column) {
          SurfacePoint& point = on.at(column, y);
          point.baked = false;
          if (point.kind != SurfaceKind::kNone) batches[batch].add(point, column, y, params_.finest_px);
          if (batches[batch].full()) turn();
        }
      }
    }
    for (int left = 0; left < 3; ++left) turn();
  });
}

void BakedLight::add(const BakedPoints& points, int per_pixel, const GBuffer& g, GridEstimate& out) const {
  for (int i = 0; i < points.count(); ++i)
    add(points[i], points.sum(0, i), points.sum(1, i), points[i].column / per_pixel, g, out);
}

void BakedLight::add(const BakedPoints::Point& found, Octet fine, Octet coarse, int x, const GBuffer& g,
                     GridEstimate& out) const {
  const int y = found.y;
  SurfacePoint& point = *found.surface;
  point.baked = coarse[kKnown] >= kLeastShare;
  if (!point.baked) return;
  const float fraction = found.at.fraction, of_fine = 1 - fraction;
  const float of_coarse = (1 - of_fine * fine[kKnown]) / coarse[kKnown];  // also what no fine vertex knows
  const Octet v = fine * of_fine + coarse * kToFine * of_coarse;
  const float U = point.unoccluded, px = std::hypot(g.motion_x.at(x, y), g.motion_y.at(x, y));
  const float cells = px * found.at.scale / params_.finest_px, share2 = point.share * point.share;
  const auto variance = [U](float rest, float visibility) { return rest + U * U * visibility; };
  const float var_i = variance(v[kVarRest], v[kVarVisibility]);
  out.i.at(x, y) += point.share * (v[kRest] + U * v[kVisibility]);
  out.var_i.at(x, y) += share2 * var_i;
  out.var_step.at(x, y) +=
      share2 * std::min(2 * var_i, cells * cells * variance(v[kStepRest], v[kStepVisibility]));
}

}  // namespace saccade
