#include "cache/grid/surface_grid.h"

#include <algorithm>
#include <cmath>

#include "cache/grid/cut_search.h"
#include "cache/grid/grid_pieces.h"
#include "cache/grid/grid_reader.h"
#include "cache/grid/ray_visibility.h"
#include "cache/grid/vertex_search.h"

namespace saccade {
namespace {

constexpr int kAhead = 4;  // pixels whose values are on their way from memory
// Sums of floats take no more than so many samples, which leave a thousandth of one sample's noise.
constexpr float kEnough = 1 << 20;

constexpr auto kAll = [](int, int) { return true; };
constexpr auto kNothingElse = [](const auto&, const PointLanes&) {};

// Adds the estimates at a few points to their pixels.
void addEstimates(const LevelBlend<PointFloats>& blend, const PointLanes& lanes, const FrameOnGrid& frame,
                  float cell_px, GridEstimate& out) {
  const SurfaceSamples& on = frame.on;
  const GBuffer& g = frame.g;
  const Placement& at = frame.at;
  LaneMemory<2> of_points;  // unoccluded light, and motion in finest cells
  std::array<int, kPointLanes> x, y;
  for (int i = 0; i < lanes.count; ++i) {
    const GridPoint& p = at.points[lanes.points[i]];
    x[i] = on.columnOf(p.index) / on.perPixel(), y[i] = on.rowOf(p.index);
    const float mx = g.motion_x.at(x[i], y[i]), my = g.motion_y.at(x[i], y[i]);
    of_points.values[0][i] = frame.residuals ? 0 : on.place(p.index).unoccluded;
    of_points.values[1][i] = std::sqrt(mx * mx + my * my) * p.scale / cell_px;
  }
  const auto [U, cells] = of_points.lanes();
  LaneMemory<3> estimate;
  PointFloats i = blend.value(U), variance = blend.variance(U), step_variance = blend.stepVariance(U, cells);
  if (const RayLanes rays(lanes, frame); rays.any()) rays.refine(blend, U, cells, i, variance, step_variance);
  store(i, estimate.values[0]), store(variance, estimate.values[1]), store(step_variance, estimate.values[2]);
  for (int i = 0; i < lanes.count; ++i) {
    const float share = on[at.points[lanes.points[i]].index].share;
    out.i.at(x[i], y[i]) += share * estimate.values[0][i];
    out.var_i.at(x[i], y[i]) += share * share * estimate.values[1][i];
    out.var_step.at(x[i], y[i]) += share * share * estimate.values[2][i];
  }
}

}  // namespace

int GridParams::pixelSlot() const {
  return std::clamp(static_cast<int>(std::lround(std::log2(1.4f / cell_px))), 0, kTop - 1);
}

SurfaceGrid::Time SurfaceGrid::place(const SurfaceSamples& on, const Obstacles* obstacles,
                                     const PoolHandle& pool, Placement& prev, Placement& out) {
  ++now_;
  if (vertices() > params_.max_vertices) drop(prev);
  Time time = pool.run(1, [&](int) { out.place(on, params_.cell_px); });
  if (out.empty()) return time;
  levels_.makeAll(out.least_level, out.most_level);
  new_.resize(std::max<std::size_t>(new_.size(), out.most_level - out.least_level + 1));
  time += forEachLevel(out, pool, [&](int l) { findVertices(l, out); });
  return time + cutAtWalls(on, obstacles, pool, out);
}

SurfaceGrid::Time SurfaceGrid::cutAtWalls(const SurfaceSamples& on, const Obstacles* obstacles,
                                          const PoolHandle& pool, Placement& out) {
  const Time time = pool.run(1, [&](int) {
    CutSearch search(on, obstacles, out, levels_, now_);
    for (int l = out.most_level; l >= out.least_level; --l) search.cut(l, new_[l - out.least_level]);
  });
  return time +
         forEachLevel(out, pool, [&](int l) { remapTaps(levels_[l], l, new_[l - out.least_level], out); });
}

void SurfaceGrid::findVertices(int l, Placement& out) {
  GridLevel& level = levels_[l];
  NewVertices& found = new_[l - out.least_level];
  found.clear();
  VertexSearch search(level, l, now_, out, found);
  forEachPointOf(out, l, [&](std::size_t, const GridPoint& p, int slot) { search.add(p, slot); });
  search.finish();
  level.resize();
}

SurfaceGrid::Added SurfaceGrid::add(const FrameOnGrid& frame, const PoolHandle& pool) {
  const SurfaceSamples& on = frame.on;
  const Placement& at = frame.at;
  samples_.resize(at.points.size());
  Time time = forEachBand(on, pool, [&](int band, int, int) {
    const auto [first, end] = at.ofBand(band);
    for (std::size_t i = first; i < end; ++i) {
      const std::uint32_t index = at.points[i].index;
      samples_[i] = Quad{};
      const auto n = static_cast<float>(on[index].paths);
      if (on[index].paths == 0) continue;
      if (frame.residuals) {
        samples_[i] = Quad{n, n * (*frame.residuals)[index], 0, 0};
        continue;
      }
      const SurfaceLight& light = on.light(index);
      const float U = on.place(index).unoccluded, inv = U > 0 ? n / U : 0;
      samples_[i] = Quad{n, n * light.residual, light.visible * inv, light.unoccluded * inv};
      if (frame.shadows && on[index].light_moves) {
        const SurfaceShadow& shadow = (*frame.shadows)[index];
        const auto rays = static_cast<float>(shadow.rays);
        samples_[i] += Quad{0, 0, rays * shadow.now.mean, rays};
      }
    }
  });
  time += forEachLevel(at, pool, [&](int l) {
    auto& light = levels_[l].light;
    forEachPointOf(at, l, [&](std::size_t i, const GridPoint& p, int slot) {
      if (slot > kTop || samples_[i][0] == 0) return;
      scatter(samples_[i], at, p, slot, light, [](const Quad& sum) { return sum[0] < kEnough; });
    });
  });
  return {frame, time};
}

SurfaceGrid::Time SurfaceGrid::learn(const Compared& compared, const PoolHandle& pool) {
  const Placement& at = compared.at;
  return forEachLevel(at, pool, [&](int l) {
    auto& evidence = levels_[l].evidence;
    forEachPointOf(at, l, [&](std::size_t i, const GridPoint& p, int slot) {
      if (slot < kPoolSteps || samples_[i][0] == 0) return;
      scatter(evidence_[i].ofSlot(slot - kPoolSteps), at, p, slot, evidence,
              [](const Octet& sum) { return sum[3] < kEnough; });
    });
  });
}

void SurfaceGrid::prefetch(const Placement& at, const GridPoint& p) const {
  constexpr int kFine = 4;  // coarser levels are at hand: pixels share them
  for (int k = 0; k < kFine; ++k) {
    const int pool = k + kPoolSteps;
    for (const auto v : at.taps[k][p.first].vertex) __builtin_prefetch(&levels_[p.level + k].light[v]);
    for (const auto v : at.taps[pool][p.first].vertex)
      __builtin_prefetch(&levels_[p.level + pool].evidence[v]);
  }
}

SurfaceGrid::Time SurfaceGrid::uncertainty(const FrameOnGrid& frame, const PoolHandle& pool, ImageF& out,
                                           ImageF* shadow_detail) const {
  const SurfaceSamples& on = frame.on;
  const Placement& at = frame.at;
  const int slot = params_.pixelSlot();
  return forEachBand(on, pool, [&](int band, int y0, int y1) {
    for (int y = y0; y < y1; ++y) {
      std::fill_n(out.row(y), out.width(), 0.f);
      if (shadow_detail) std::fill_n(shadow_detail->row(y), out.width(), 0.f);
    }
    const auto [first, end] = at.ofBand(band);
    for (std::size_t i = first; i < end; ++i) {
      const GridPoint& p = at.points[i];
      const Quad l = gather(levels_[p.level + slot].light, at, p, slot);
      const Octet e = gather(levels_[p.level + slot + kPoolSteps].evidence, at, p, slot + kPoolSteps);
      const bool known = l[0] > 0 && e[3] > 0, shadows = l[3] > 0 && e[7] > 0;
      const float U = on.place(p.index).unoccluded;
      const float light = l[1] / l[0] + (shadows ? U * l[2] / l[3] : 0);
      const float of_rays = shadow_detail ? shadowVariance(l, e, U, params_.blend) : 0;
      float variance = varianceOf<float>(e[2], e[3], l[0], params_.blend);
      if (of_rays == 0) variance += U * U * varianceOf<float>(e[6], e[7], l[3], params_.blend);
      out.at(on.columnOf(p.index), on.rowOf(p.index)) =
          known ? std::sqrt(variance) / std::max(light, 1e-6f) : kUnknown;
      if (shadow_detail) shadow_detail->at(on.columnOf(p.index), on.rowOf(p.index)) = of_rays;
    }
  });
}

// Sets the pixels of each band for which wanted(x, y), and calls each(blend, lanes) for a few of its points
// at once.
SurfaceGrid::Time SurfaceGrid::readBands(const FrameOnGrid& frame, const PoolHandle& pool, const auto& wanted,
                                         const auto& each, GridEstimate& out) const {
  const SurfaceSamples& on = frame.on;
  const Placement& at = frame.at;
  return forEachBand(on, pool, [&](int band, int, int) {
    const auto ends = at.ofBand(band);
    const auto forEachWanted = [&](const auto& f) {
      for (std::size_t i = ends.first; i < ends.second; ++i) {
        const std::uint32_t index = at.points[i].index;
        const int x = on.columnOf(index) / on.perPixel(), y = on.rowOf(index);
        if (wanted(x, y)) f(i, x, y);
      }
    };
    forEachWanted([&](std::size_t, int x, int y) { out.clear({x, y, x + 1, y + 1}); });
    PointLanes lanes;
    const auto finish = [&] {
      const LevelBlend<PointFloats> blend = lanes.blend(params_.blend);
      addEstimates(blend, lanes, frame, params_.cell_px, out);
      each(blend, lanes);
      lanes.count = 0;
    };
    forEachWanted([&](std::size_t i, int, int) {
      if (i + kAhead < ends.second) prefetch(at, at.points[i + kAhead]);
      lanes.add(levels_, at, i);
      if (lanes.full()) finish();
    });
    if (lanes.count > 0) finish();
  });
}

SurfaceGrid::Time SurfaceGrid::read(const FrameOnGrid& frame, const PoolHandle& pool,
                                    GridEstimate& out) const {
  return readBands(frame, pool, kAll, kNothingElse, out);
}

void SurfaceGrid::readPoints(std::span<const PointSample> at, std::span<PlaceLight> out) const {
  GridReader(levels_, params_).read(at, out);
}

SurfaceGrid::Compared SurfaceGrid::readAdded(const Added& added, const PoolHandle& pool, GridEstimate& out) {
  const Placement& at = added.frame.at;
  evidence_.resize(at.points.size());
  const auto compare = [&](const auto& blend, const PointLanes& lanes) {
    findEvidence(blend, lanes, samples_, at, evidence_);
  };
  return {at, readBands(added.frame, pool, kAll, compare, out)};
}

SurfaceGrid::Time SurfaceGrid::readAgain(const FrameOnGrid& frame, const PoolHandle& pool,
                                         const ImageF& uncertainty, const ImageF& uncertainty_prev,
                                         GridEstimate& out) const {
  const SurfaceSamples& on = frame.on;
  const auto unknown = [&](int x, int y) {
    for (int column = x * on.perPixel(); column < (x + 1) * on.perPixel(); ++column)
      if (uncertainty.at(column, y) == kUnknown || uncertainty_prev.at(column, y) == kUnknown) return true;
    return false;
  };
  return readBands(frame, pool, unknown, kNothingElse, out);
}

}  // namespace saccade
