#include "cache/bake/baked_light.h"

#include <algorithm>
#include <cmath>

#include "cache/bake/baked_batch.h"

namespace saccade {
namespace {

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

// f(x, y) for each pixel of a tile, by squares within squares: neighbours in both directions share blocks of
// vertices.
void forEachPixelBySquares(Tile tile, const auto& f) {
  constexpr unsigned kSquare = 8, kBitsOfX = 0x15, kBitsOfY = 0x2a;  // pixels; of a place along the curve
  for (int y0 = tile.y0; y0 < tile.y1; y0 += kSquare)
    for (int x0 = tile.x0; x0 < tile.x1; x0 += kSquare)
      for (unsigned place = 0; place < kSquare * kSquare; ++place) {
        const int x = x0 + static_cast<int>(_pext_u32(place, kBitsOfX));
        const int y = y0 + static_cast<int>(_pext_u32(place, kBitsOfY));
        if (x < tile.x1 && y < tile.y1) f(x, y);
      }
}

// A pixel whose light is known in part is not known.
void leavePartsOut(std::span<SurfacePoint> of_pixel, int x, int y, GridEstimate& out) {
  const auto isLive = [](const SurfacePoint& p) { return p.kind != SurfaceKind::kNone && !p.baked; };
  if (std::ranges::none_of(of_pixel, isLive)) return;
  for (SurfacePoint& p : of_pixel) p.baked = p.near_shadow = false;
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

// Reads the points that forEachPoint(f) calls f(point, place, kind) with, and calls each(points) for a few of
// them.
void BakedLight::forEachBatch(const auto& forEachPoint, const auto& each) const {
  constexpr int kSteps = 4;
  std::array<BakedPoints, kSteps> batches;  // wanted, located, found and read in turn
  int batch = 0;
  const auto turn = [&] {
    batches[batch].want(levels_, params_.cell_px);
    batches[(batch + 3) % kSteps].locate();
    batches[(batch + 2) % kSteps].find();
    batch = (batch + 1) % kSteps;
    BakedPoints& points = batches[batch];
    if (points.count() > 0) each(points);
    points.clear();
  };
  forEachPoint([&](const BakedPoints::Point& point, const SurfacePlace& place, SurfaceKind kind) {
    batches[batch].add(point, place, kind);
    if (batches[batch].full()) turn();
  });
  for (int left = 0; left < kSteps; ++left) turn();
}

void BakedLight::read(Tile tile, SurfaceSamples& on, const GBuffer& g, GridEstimate& out) const {
  out.clear(tile);
  const auto forEachPoint = [&](const auto& f) {
    forEachPixelBySquares(tile, [&](int x, int y) {
      for (int i = 0; i < on.perPixel(); ++i) {
        const std::size_t index = on.indexOf(x * on.perPixel() + i, y);
        on[index].baked = on[index].near_shadow = false;
        if (on[index].kind != SurfaceKind::kNone)
          f({x, y, static_cast<std::uint32_t>(index)}, on.place(index), on[index].kind);
      }
    });
  };
  forEachBatch(forEachPoint, [&](const BakedPoints& points) {
    const BakedBatch light(points, on, g, scale_, params_.cell_px);
    light.mark(on);
    light.add({}, out);
  });
  if (on.perPixel() == 1) return;
  for (int y = tile.y0; y < tile.y1; ++y)
    for (int x = tile.x0; x < tile.x1; ++x) leavePartsOut(on.of(x, y), x, y, out);
}

void BakedLight::readAgain(std::span<const Pixel> pixels, const SurfaceSamples& on, const GBuffer& g,
                           const FrameShadows& shadows, GridEstimate& out) const {
  const auto forEachPoint = [&](const auto& f) {
    for (const auto& [x, y] : pixels) {
      bool any = false;
      for (int i = 0; i < on.perPixel(); ++i) {
        const std::size_t index = on.indexOf(x * on.perPixel() + i, y);
        if (!on[index].baked) continue;
        if (!any) out.clear({x, y, x + 1, y + 1});
        any = true;
        f({x, y, static_cast<std::uint32_t>(index)}, on.place(index), on[index].kind);
      }
    }
  };
  forEachBatch(forEachPoint, [&](const BakedPoints& points) {
    RayLanes of_points;
    for (int i = 0; shadows.all && i < points.count(); ++i)
      of_points.set(i, (*shadows.all)[points[i].index], shadows.visibility);
    BakedBatch(points, on, g, scale_, params_.cell_px).add(of_points, out);
  });
}

void BakedLight::read(std::span<const PointSample> at, std::span<PlaceLight> out) const {
  const auto forEachPoint = [&](const auto& f) {
    for (std::size_t k = 0; k < at.size(); ++k) {
      out[k] = {};
      if (at[k].kind != SurfaceKind::kNone) f({0, 0, static_cast<std::uint32_t>(k)}, at[k].place, at[k].kind);
    }
  };
  forEachBatch(forEachPoint, [&](const BakedPoints& points) {
    const BakedMeans mean(points, points.light().means, scale_);
    LaneMemory<4> lanes;
    store(mean.residual, lanes.values[0]), store(mean.visibility, lanes.values[1]);
    BakedMeans::Shadows shadows;
    if (points.anyNearShadow()) {
      for (int i = 0; i < points.count(); ++i) lanes.values[2][i] = at[points[i].index].place.unoccluded;
      const BakedPoints::F variance = points.shadows();
      shadows = mean.shadows(load<kPointLanes>(lanes.values[2]), variance);
      store(variance, lanes.values[3]);
    }
    forEachLane(mean.known, [&](int i) {
      out[points[i].index] = {.known = true,
                              .residual = lanes.values[0][i],
                              .visibility = lanes.values[1][i],
                              .shadow = shadows.near.has(i) ? lanes.values[3][i] : 0,
                              .shadow_visible = shadows.visible.has(i)};
    });
  });
}

}  // namespace saccade
