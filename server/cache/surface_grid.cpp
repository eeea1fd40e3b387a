#include "cache/surface_grid.h"

#include <cmath>

namespace saccade {
namespace {

constexpr int kAhead = 4;  // pixels whose values are on their way from memory
// Sums of floats take no more than so many samples, which leave a thousandth of one sample's noise.
constexpr float kEnough = 1 << 20;

// One piece for each level: vertices and sums are the same for any number of threads.
template <class F>
SurfaceGrid::Time forEachLevel(const Placement& at, const PoolHandle& pool, const F& f) {
  if (at.empty()) return {};
  return pool.run(at.most_level - at.least_level + 1, [&](int i) { f(at.least_level + i); });
}

// f(pixel, point, slot) for the points that take part in level l, in order.
template <class F>
void forEachPointOf(const Placement& at, int l, const F& f) {
  for (std::size_t pixel = 0; pixel < at.points.size(); ++pixel) {
    const GridPoint& p = at.points[pixel];
    if (const int slot = l - p.level; p.inSlot(slot)) f(pixel, p, slot);
  }
}

}  // namespace

SurfaceGrid::Time SurfaceGrid::place(const SurfaceSamples& on, const GBuffer& g, const PoolHandle& pool,
                                     Placement& prev, Placement& out, const Image<std::uint32_t>* left_out) {
  ++now_;
  if (vertices() > params_.max_vertices) drop(prev);
  const Time time = pool.run(1, [&](int) { out.place(on, g, params_.finest_px, left_out); });
  if (!out.empty()) levels_.makeAll(out.least_level, out.most_level);
  return time + forEachLevel(out, pool, [&](int l) { findVertices(l, out); });
}

void SurfaceGrid::findVertices(int l, Placement& out) {
  struct Found {
    std::array<VertexTable::Place, 4> places;
    Taps* taps = nullptr;
  };
  constexpr std::uint32_t kOnTheWay = 8;
  std::array<Found, kOnTheWay> found{};
  std::uint32_t count = 0;
  GridLevel& level = levels_[l];
  VertexTable::Finder finder(level.table, now_);
  const auto finish = [&](const Found& f) {
    for (int c = 0; c < 4; ++c) f.taps->vertex[c] = level.table.indexAt(f.places[c]);
  };
  const double inv_h = std::ldexp(1.0, -l);
  forEachPointOf(out, l, [&](std::size_t, const GridPoint& p, int slot) {
    const Vec3d q = toDouble(p.position) * inv_h;
    for (std::uint32_t t = p.first; t < p.first + p.count; ++t, ++count) {
      const Tetrahedron corners(q, out.bins[t]);
      Found& f = found[count % kOnTheWay];
      if (count >= kOnTheWay) finish(f);
      f.taps = &out.taps[slot][t];
      for (int c = 0; c < 4; ++c) {
        f.places[c] = finder.find(corners.key[c]);
        f.taps->weight[c] = corners.weight[c] * out.bin_weights[t];
      }
    }
  });
  for (std::uint32_t i = count > kOnTheWay ? count - kOnTheWay : 0; i < count; ++i)
    finish(found[i % kOnTheWay]);
  level.light.resize(level.table.size());
  level.evidence.resize(level.table.size());
}

SurfaceGrid::Time SurfaceGrid::add(const SurfaceSamples& on, const Placement& at, const PoolHandle& pool) {
  samples_.resize(at.points.size());
  const Time time = pool.forEachRow(on.x.height(), [&](int y) {
    for (int x = 0; x < on.x.width(); ++x) {
      const auto n = static_cast<float>(on.paths.at(x, y));
      const float U = on.unoccluded.at(x, y), inv = U > 0 ? n / U : 0;
      samples_[static_cast<std::size_t>(y) * on.x.width() + x] = Quad{
          n, n * on.rest.at(x, y), on.visible_sample.at(x, y) * inv, on.unoccluded_sample.at(x, y) * inv};
    }
  });
  return time + forEachLevel(at, pool, [&](int l) {
           auto& light = levels_[l].light;
           forEachPointOf(at, l, [&](std::size_t pixel, const GridPoint& p, int slot) {
             if (slot > kTop || samples_[pixel][0] == 0) return;
             scatter(samples_[pixel], at, p, slot, light, [](const Quad& sum) { return sum[0] < kEnough; });
           });
         });
}

SurfaceGrid::Time SurfaceGrid::learn(const Placement& at, const PoolHandle& pool) {
  return forEachLevel(at, pool, [&](int l) {
    auto& evidence = levels_[l].evidence;
    forEachPointOf(at, l, [&](std::size_t pixel, const GridPoint& p, int slot) {
      if (slot < kPoolSteps || samples_[pixel][0] == 0) return;
      scatter(evidence_[pixel].ofSlot(slot - kPoolSteps), at, p, slot, evidence,
              [](const Octet& sum) { return sum[3] < kEnough; });
    });
  });
}

void SurfaceGrid::prefetch(const Placement& at, const GridPoint& p) const {
  constexpr int kFine = 4;  // coarser levels are at hand: pixels share them
  if (p.count == 0) return;
  for (int k = 0; k < kFine; ++k) {
    const int pool = k + kPoolSteps;
    for (const auto v : at.taps[k][p.first].vertex) __builtin_prefetch(&levels_[p.level + k].light[v]);
    for (const auto v : at.taps[pool][p.first].vertex)
      __builtin_prefetch(&levels_[p.level + pool].evidence[v]);
  }
}

SurfaceGrid::Time SurfaceGrid::uncertainty(const SurfaceSamples& on, const Placement& at,
                                           const PoolHandle& pool, ImageF& out) const {
  constexpr int kSlot = 1;  // of cells of about a pixel
  return pool.forEachRow(on.x.height(), [&](int y) {
    for (int x = 0; x < on.x.width(); ++x) {
      const GridPoint& p = at.points[static_cast<std::size_t>(y) * on.x.width() + x];
      out.at(x, y) = 0;
      if (p.count == 0) continue;
      const Quad l = gather(levels_[p.level + kSlot].light, at, p, kSlot);
      const Octet e = gather(levels_[p.level + kSlot + kPoolSteps].evidence, at, p, kSlot + kPoolSteps);
      const bool known = l[0] > 0 && e[3] > 0, shadows = l[3] > 0 && e[7] > 0;
      const float U = on.unoccluded.at(x, y);
      const float variance =
          varianceOf(e[2], e[3], l[0], params_.blend) + U * U * varianceOf(e[6], e[7], l[3], params_.blend);
      const float i = l[1] / l[0] + (shadows ? U * l[2] / l[3] : 0);
      out.at(x, y) = known ? std::sqrt(variance) / std::max(i, 1e-6f) : kUnknown;
    }
  });
}

// Reads the pixels of a row for which wanted(x), and calls each(blend, pixel).
void SurfaceGrid::readRow(const SurfaceSamples& on, const GBuffer& g, const Placement& at, int y,
                          const auto& wanted, const auto& each, GridEstimate& out) const {
  for (int x = 0; x < on.x.width(); ++x) {
    const std::size_t pixel = static_cast<std::size_t>(y) * on.x.width() + x;
    const GridPoint& p = at.points[pixel];
    if (!wanted(x)) continue;
    out.i.at(x, y) = out.var_i.at(x, y) = out.var_step.at(x, y) = 0;
    if (x + kAhead < on.x.width()) prefetch(at, at.points[pixel + kAhead]);
    if (p.count == 0) continue;
    const LevelBlend blend(levels_, at, p, params_.blend);
    const float U = on.unoccluded.at(x, y), px = std::hypot(g.motion_x.at(x, y), g.motion_y.at(x, y));
    out.i.at(x, y) = blend.value(U);
    out.var_i.at(x, y) = blend.variance(U);
    out.var_step.at(x, y) = blend.stepVariance(U, px * std::exp2(p.fraction) / params_.finest_px);
    each(blend, pixel);
  }
}

SurfaceGrid::Time SurfaceGrid::read(const SurfaceSamples& on, const GBuffer& g, const Placement& at,
                                    const PoolHandle& pool, GridEstimate& out) const {
  return pool.forEachRow(on.x.height(), [&](int y) {
    readRow(
        on, g, at, y, [](int) { return true; }, [](const LevelBlend&, std::size_t) {}, out);
  });
}

SurfaceGrid::Time SurfaceGrid::readAdded(const SurfaceSamples& on, const GBuffer& g, const Placement& at,
                                         const PoolHandle& pool, GridEstimate& out) {
  evidence_.resize(at.points.size());
  const auto compare = [&](const LevelBlend& blend, std::size_t pixel) {
    evidence_[pixel] = evidenceOf(blend, samples_[pixel], at, at.points[pixel]);
  };
  return pool.forEachRow(on.x.height(), [&](int y) {
    readRow(
        on, g, at, y, [](int) { return true; }, compare, out);
  });
}

SurfaceGrid::Time SurfaceGrid::readAgain(const SurfaceSamples& on, const GBuffer& g, const Placement& at,
                                         const PoolHandle& pool, const ImageF& uncertainty,
                                         const ImageF& uncertainty_prev, GridEstimate& out) const {
  return pool.forEachRow(on.x.height(), [&](int y) {
    const auto unknown = [&](int x) {
      return uncertainty.at(x, y) == kUnknown || uncertainty_prev.at(x, y) == kUnknown;
    };
    readRow(
        on, g, at, y, unknown, [](const LevelBlend&, std::size_t) {}, out);
  });
}

}  // namespace saccade
