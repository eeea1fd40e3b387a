#include "cache/surface_grid.h"

#include <cmath>

#include "base/check.h"

namespace saccade {
namespace {

using Quad = SurfaceGrid::Quad;

template <class V>
V gather(const std::vector<V>& values, const Placement& at, const GridPoint& p, int slot) {
  V sum{};
  for (std::uint32_t t = p.first; t < p.first + p.count; ++t) {
    const Taps& taps = at.taps[slot][t];
    for (int i = 0; i < 4; ++i) sum += values[taps.vertex[i]] * taps.weight[i];
  }
  return sum;
}

// The share of a pixel's own sample in what it gathers.
float ownShare(const Placement& at, const GridPoint& p, int slot) {
  float sum = 0;
  for (std::uint32_t t = p.first; t < p.first + p.count; ++t)
    for (const float w : at.taps[slot][t].weight) sum += w * w;
  return sum;
}

constexpr int kAhead = 4;              // pixels whose values are on their way from memory
constexpr int kTop = kGridLevels - 1;  // the slot of the coarsest level

// One kind of light at a point, from coarse to fine: E += alpha (E_k - E), with alpha the share of the detail
// of level k that is not noise.
struct Channel {
  float value = 0, variance = 0;  // of the estimate so far
  std::array<float, kTop> alpha{}, level_variance{};

  void refine(int k, float level_value, float share, float noise) {
    alpha[k] = share;
    level_variance[k] = noise;
    value += share * (level_value - value);
    variance = (1 - share) * (1 - share) * variance + share * share * noise;
  }
  // Variance of the change over a step of `cells` finest cells: the weights of vertices change by about as
  // much.
  float stepVariance(float cells) const {
    float sum = 0, left = 1;
    for (int k = 0; k < kTop; ++k, cells *= 0.5f) {
      const float w = alpha[k] * left;
      sum += w * w * std::min(2.f, 2 * cells * cells) * level_variance[k];
      left *= 1 - alpha[k];
    }
    return sum;
  }
};

// Evidence is the sums of x, x^2, squared residuals, and the weights of samples.
struct Share {
  float alpha = 0, noise = 0;
};
Share shareOf(float x, float x2, float residual2, float count, float samples, const GridParams& p) {
  if (count <= 0 || samples <= 0) return {};
  const float energy = std::max(0.f, x - p.tau * std::sqrt(x2)) / count;
  const float noise = p.noise * residual2 / (count * samples);
  return {energy > 0 ? energy / (energy + noise) : 0, noise};
}

}  // namespace

// What all levels say at a point.
struct SurfaceGrid::Chain {
  Channel rest, visibility;
  std::array<Quad, kGridLevels> light;  // gathered, by slot
  bool judged = false;                  // whether there is evidence for slot 1

  Chain(const SurfaceGrid& grid, const Placement& at, const GridPoint& p) {
    visibility.value = 1;
    light[kTop] = gather(grid.level(p.level + kTop).light, at, p, kTop);
    if (light[kTop][0] > 0) rest.value = light[kTop][1] / light[kTop][0];
    if (light[kTop][3] > 0) visibility.value = light[kTop][2] / light[kTop][3];
    for (int k = kTop - 1; k >= 0; --k) {
      const Quad l = light[k] = gather(grid.level(p.level + k).light, at, p, k);
      const auto e = gather(grid.level(p.level + k + kPoolSteps).evidence, at, p, k + kPoolSteps);
      if (k == 1) judged = e[3] > 0;
      refine(rest, k, l[1], l[0], shareOf(e[0], e[1], e[2], e[3], l[0], grid.params_), p.fraction);
      refine(visibility, k, l[2], l[3], shareOf(e[4], e[5], e[6], e[7], l[3], grid.params_), p.fraction);
    }
  }
  // Standard deviation of what the level of slot 1 says, its detail believed or not; kUnknown before it has said
  // anything.
  float uncertainty(float U) const {
    if (light[1][0] <= 0 || !judged) return GridEstimate::kUnknown;
    return std::sqrt(rest.level_variance[1] + U * U * visibility.level_variance[1]);
  }
  // The finest level fades out, and the coarsest fades in, as the point moves away.
  static void refine(Channel& c, int k, float sum, float samples, Share share, float fraction) {
    if (samples <= 0) return;
    if (k == kTop - 1) share.alpha += (1 - fraction) * (1 - share.alpha);
    if (k == 0) share.alpha *= 1 - fraction;
    c.refine(k, sum / samples, share.alpha, share.noise);
  }
};

SurfaceGrid::Time SurfaceGrid::place(const SurfaceSamples& on, const GBuffer& g, const PoolHandle& pool,
                                     Placement& out) {
  Time time = pool.run(1, [&](int) { out.place(on, g, params_.finest_px); });
  if (out.most_level < out.least_level) return time;
  SACCADE_CHECK(out.least_level >= kLeastLevel && out.most_level <= kMostLevel);
  for (int l = out.least_level; l <= out.most_level; ++l)
    if (!levels_[l - kLeastLevel]) levels_[l - kLeastLevel] = std::make_unique<Level>();
  // Levels in parallel, the pixels of each in order: the same for any number of threads.
  return time + pool.run(out.most_level - out.least_level + 1,
                         [&](int i) { findVertices(on, out.least_level + i, out); });
}

void SurfaceGrid::findVertices(const SurfaceSamples& on, int l, Placement& out) {
  constexpr int kAhead = 16;  // taps whose slots are on their way from memory
  struct Wanted {
    std::array<VertexKey, 4> keys;
    Taps* taps;
  };
  std::array<Wanted, kAhead> wanted{};
  Level& lev = level(l);
  std::uint32_t count = 0;
  Wanted last{};
  const auto resolve = [&](const Wanted& w) {
    for (int c = 0; c < 4; ++c)
      w.taps->vertex[c] =
          last.taps && w.keys[c] == last.keys[c] ? last.taps->vertex[c] : lev.table.findOrAdd(w.keys[c]);
    last = w;
  };
  const double inv_h = std::ldexp(1.0, -l);
  for (int y = 0; y < on.x.height(); ++y) {
    for (int x = 0; x < on.x.width(); ++x) {
      const GridPoint& p = out.points[static_cast<std::size_t>(y) * on.x.width() + x];
      const int slot = l - p.level;
      if (!p.inSlot(slot)) continue;
      const Vec3d q{on.x.at(x, y) * inv_h, on.y.at(x, y) * inv_h, on.z.at(x, y) * inv_h};
      for (std::uint32_t t = p.first; t < p.first + p.count; ++t) {
        const Tetrahedron corners(q, out.bins[t]);
        Wanted& w = wanted[count % kAhead];
        if (count >= kAhead) resolve(w);
        w = {corners.key, &out.taps[slot][t]};
        for (int c = 0; c < 4; ++c) w.taps->weight[c] = corners.weight[c] * out.bin_weights[t];
        const auto& before = wanted[(count + kAhead - 1) % kAhead].keys;
        for (int c = 0; c < 4; ++c)
          if (w.keys[c] != before[c]) lev.table.prefetch(w.keys[c]);
        ++count;
      }
    }
  }
  for (std::uint32_t i = count > kAhead ? count - kAhead : 0; i < count; ++i) resolve(wanted[i % kAhead]);
  lev.light.resize(lev.table.size());
  lev.evidence.resize(lev.table.size());
}

void SurfaceGrid::forget() {
  for (const auto& l : levels_) {
    if (!l) continue;
    std::fill(l->light.begin(), l->light.end(), Quad{});
    std::fill(l->evidence.begin(), l->evidence.end(), Octet{});
  }
}

SurfaceGrid::Time SurfaceGrid::add(const SurfaceSamples& on, const Placement& at, const PoolHandle& pool) {
  if (at.most_level < at.least_level) return {};
  samples_.resize(at.points.size());
  const Time time = pool.forEachRow(on.x.height(), [&](int y) {
    for (int x = 0; x < on.x.width(); ++x) {
      const auto n = static_cast<float>(on.paths.at(x, y));
      const float U = on.unoccluded.at(x, y), inv = U > 0 ? n / U : 0;
      samples_[static_cast<std::size_t>(y) * on.x.width() + x] = Quad{
          n, n * on.rest.at(x, y), on.visible_sample.at(x, y) * inv, on.unoccluded_sample.at(x, y) * inv};
    }
  });
  return time +
         pool.run(at.most_level - at.least_level + 1, [&](int i) { addLight(at, at.least_level + i); });
}

void SurfaceGrid::addLight(const Placement& at, int l) {
  auto& light = level(l).light;
  for (std::size_t pixel = 0; pixel < at.points.size(); ++pixel) {
    const GridPoint& p = at.points[pixel];
    const int slot = l - p.level;
    if (!p.inSlot(slot) || slot > kTop || samples_[pixel][0] == 0) continue;
    for (std::uint32_t t = p.first; t < p.first + p.count; ++t) {
      const Taps& taps = at.taps[slot][t];
      for (int i = 0; i < 4; ++i) light[taps.vertex[i]] += samples_[pixel] * taps.weight[i];
    }
  }
}

namespace {

void store(const Channel& rest, const Channel& visibility, const GridPoint& p, float U, float px, int x,
           int y, GridEstimate& out) {
  const float cells = px * std::exp2(p.fraction);
  out.i.at(x, y) = rest.value + U * visibility.value;
  out.var_i.at(x, y) = rest.variance + U * U * visibility.variance;
  out.var_step.at(x, y) = rest.stepVariance(cells) + U * U * visibility.stepVariance(cells);
}

}  // namespace

template <class Each>
SurfaceGrid::Time SurfaceGrid::forEachPoint(const SurfaceSamples& on, const GBuffer& g, const Placement& at,
                                            const PoolHandle& pool, GridEstimate& out,
                                            const Each& each) const {
  return pool.forEachRow(on.x.height(), [&](int y) {
    for (int x = 0; x < on.x.width(); ++x) {
      const std::size_t pixel = static_cast<std::size_t>(y) * on.x.width() + x;
      const GridPoint& p = at.points[pixel];
      out.i.at(x, y) = out.var_i.at(x, y) = out.var_step.at(x, y) = out.uncertainty.at(x, y) = 0;
      if (x + kAhead < on.x.width()) prefetch(at, at.points[pixel + kAhead]);
      if (p.count == 0) continue;
      const Chain chain(*this, at, p);
      const float px = std::hypot(g.motion_x.at(x, y), g.motion_y.at(x, y)) / params_.finest_px;
      store(chain.rest, chain.visibility, p, on.unoccluded.at(x, y), px, x, y, out);
      out.uncertainty.at(x, y) = chain.uncertainty(on.unoccluded.at(x, y));
      each(chain, pixel);
    }
  });
}

void SurfaceGrid::prefetch(const Placement& at, const GridPoint& p) const {
  constexpr int kFine = 4;  // coarser levels are at hand: pixels share them
  if (p.count == 0) return;
  for (int k = 0; k < kFine; ++k) {
    for (const std::uint32_t v : at.taps[k][p.first].vertex) __builtin_prefetch(&level(p.level + k).light[v]);
    for (const std::uint32_t v : at.taps[k + kPoolSteps][p.first].vertex)
      __builtin_prefetch(&level(p.level + k + kPoolSteps).evidence[v]);
  }
}

SurfaceGrid::Time SurfaceGrid::read(const SurfaceSamples& on, const GBuffer& g, const Placement& at,
                                    const PoolHandle& pool, GridEstimate& out) const {
  return forEachPoint(on, g, at, pool, out, [](const Chain&, std::size_t) {});
}

SurfaceGrid::Time SurfaceGrid::readAdded(const SurfaceSamples& on, const GBuffer& g, const Placement& at,
                                         const PoolHandle& pool, GridEstimate& out) {
  findings_.resize(at.points.size());
  return forEachPoint(on, g, at, pool, out, [&](const Chain& chain, std::size_t pixel) {
    findings_[pixel] = compare(chain, at, pixel);
  });
}

// With c what coarser levels say and d the detail of a level, both without the sample itself, x = (sample -
// c) d has the mean of what is truly there of d^2: the sample knows nothing of the noise of d.
SurfaceGrid::Finding SurfaceGrid::compare(const Chain& chain, const Placement& at, std::size_t pixel) const {
  constexpr float kLeastSamples = 1e-3f;
  Finding f{};
  const Quad sample = samples_[pixel];  // sums over its paths
  float rest = 0, visibility = 1;
  for (int k = kTop; k >= 0; --k) {
    const Quad others = chain.light[k] - sample * ownShare(at, at.points[pixel], k);
    const float level_rest = others[0] > kLeastSamples ? others[1] / others[0] : rest;
    const float level_visibility = others[3] > kLeastSamples ? others[2] / others[3] : visibility;
    if (k == kTop) {
      rest = level_rest, visibility = level_visibility;
      continue;
    }
    f.rest[k] = (sample[1] - rest * sample[0]) * (level_rest - rest);
    f.visibility[k] = (sample[2] - visibility * sample[3]) * (level_visibility - visibility);
    rest += chain.rest.alpha[k] * (level_rest - rest);
    visibility += chain.visibility.alpha[k] * (level_visibility - visibility);
  }
  f.residual_rest = sample[1] - rest * sample[0];
  f.residual_visibility = sample[2] - visibility * sample[3];
  f.paths = sample[0];
  f.unoccluded = sample[3];
  return f;
}

SurfaceGrid::Time SurfaceGrid::learn(const Placement& at, const PoolHandle& pool) {
  if (at.most_level < at.least_level) return {};
  return pool.run(at.most_level - at.least_level + 1, [&](int i) { addEvidence(at, at.least_level + i); });
}

void SurfaceGrid::addEvidence(const Placement& at, int l) {
  auto& evidence = level(l).evidence;
  for (std::size_t pixel = 0; pixel < at.points.size(); ++pixel) {
    const GridPoint& p = at.points[pixel];
    const int slot = l - p.level, k = slot - kPoolSteps;
    if (!p.inSlot(slot) || k < 0) continue;
    const Finding& f = findings_[pixel];
    if (f.paths == 0) continue;
    const auto square = [](float v) { return v * v; };
    const Octet e{f.rest[k],       square(f.rest[k]),       square(f.residual_rest),       f.paths,
                  f.visibility[k], square(f.visibility[k]), square(f.residual_visibility), f.unoccluded};
    for (std::uint32_t t = p.first; t < p.first + p.count; ++t) {
      const Taps& taps = at.taps[slot][t];
      for (int i = 0; i < 4; ++i) evidence[taps.vertex[i]] += e * taps.weight[i];
    }
  }
}

std::size_t SurfaceGrid::vertices() const {
  std::size_t sum = 0;
  for (const auto& l : levels_)
    if (l) sum += l->table.size();
  return sum;
}

}  // namespace saccade
