#include "methods/irradiance_cache.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "filter/demodulation.h"
#include "methods/param_fields.h"
#include "methods/path_plan.h"

namespace saccade {
namespace {

using P = IrradianceCacheParams;

const std::vector<ParamField<P>>& fields() {
  static const std::vector<ParamField<P>> table{
      {"cell_px", &P::cell_px, 0.1, 16,
       "edge of the finest cells with 2 paths, pixels; it is scaled by sqrt(2 / spp), to 0.35 at least",
       "[ours]", "finest"},
      {"tau", &P::tau, 0, 10, "standard deviations by which detail must exceed its noise", "[ours]"},
      {"noise", &P::noise, 0.001, 100, "variance of an interpolated mean, relative to that of one sample",
       "[ours]"},
      {"noise_weight", &P::noise_weight, 0, 100,
       "weight of noise against energy when detail is kept or dropped", "[ours]", "caution"},
      {"iterations", &P::iterations, 0, 5, "a-trous iterations, of spacing 1, 2, 4, ...", "[ours]"},
      {"sigma_l", &P::sigma_l, 0.01, 1000,
       "luminance tolerance of the primal, standard deviations of the mean", "[ours]"},
      {"sigma_l_diff", &P::sigma_l_diff, 0.01, 1000, "luminance tolerance of the difference, likewise",
       "[ours]"},
      {"target", &P::target, 0.0001, 10,
       "relative error below which a pixel gets fewer paths; it is scaled by sqrt(2 / spp)", "[ours]"},
      {"grid_paths", &P::grid_paths, 0, 64,
       "time of the grid in paths per pixel: so many paths are dropped, at most half of spp", "[ours]"},
      {"memory_mib", &P::memory_mib, 1, 65536,
       "MiB of the grid, which has at most 5 kB per pixel; at least what two frames need", "[ours]",
       "memory"},
      {"sigma_n", &P::sigma_n, 0, 1024, "normal exponent [E (24)]", "Falcor"},
      {"sigma_z", &P::sigma_z, 0.01, 1000, "depth tolerance, slopes [E (23)]", "Falcor"},
  };
  return table;
}

// With a bake. Three of them bring 6 % fewer false events, and 5 % more missed ones.
constexpr int kBakedIterations = 1;

// Frames after a change of light, until 3 % of it are missing in a history of SVGF.
constexpr std::uint32_t kCatchUp = 32;

// The share of what is known of a point that holds in the next frame.
float keptOf(const SurfacePoint& point) {
  return point.light_moves ? 0.9f : 1;
}

// Whether a pixel shows the same surface in both frames.
bool showsSame(const FramePair& frames, int x, int y) {
  const GBuffer &g = frames.cur.g, &before = frames.prev.g;
  if (g.body.at(x, y) != before.body.at(x, y)) return false;
  const Vec3 n{g.nx.at(x, y), g.ny.at(x, y), g.nz.at(x, y)},
      n_before{before.nx.at(x, y), before.ny.at(x, y), before.nz.at(x, y)};
  const float z = g.z.at(x, y);
  return dot(n, n_before) > 0.9f && std::abs(z - before.z.at(x, y)) < 10 * g.dz.at(x, y) + 0.02f * z;
}

// More paths prove finer detail.
float cellEdge(float cell_px, int spp) {
  constexpr float kLeast = 0.35f;
  return std::max(std::min(kLeast, cell_px), cell_px * std::sqrt(2 / static_cast<float>(std::max(2, spp))));
}

// Bytes of a grid: what `memory_mib` allows, but no more than 25 pictures show that have nothing in common.
double gridBytes(int memory, double pixels) {
  constexpr double kMostPerPixel = 5000;
  return std::min(memory * double(1 << 20), kMostPerPixel * pixels);
}

// Measured with the least `memory_mib` on pictures of 512x512 of curved meshes and of the staircase.
double mostBytes(const ParamValues& params, double pixels, bool jitter) {
  constexpr double kPlaces = 1900, kMorePlaces = 1700, kTwoFrames = 600;  // per pixel
  constexpr double kPairs = 500, kMorePairs = 1000;                       // where a picture shows metals
  constexpr double kShadows = 300, kMoreShadows = 900;                    // rays to four lamps
  return pixels * (kPlaces + kPairs + kShadows + (jitter ? kMorePlaces + kMorePairs + kMoreShadows : 0)) +
         std::max(pixels * kTwoFrames, gridBytes(static_cast<int>(params.at("memory_mib")), pixels));
}

}  // namespace

MethodInfo IrradianceCache::info() {
  return {"irradiance_cache",
          "caches light on surfaces, and reads the change from it: for lamps that are steady",
          paramSpecs(fields()),
          [](const ParamValues&) -> SeedPlanner { return SeedPlan::independent; },
          [](const MethodSetup& setup) -> std::unique_ptr<Method> {
            return std::make_unique<IrradianceCache>(makeParams(fields(), setup.params), setup.width,
                                                     setup.height, setup.spp, setup.baked);
          },
          true,
          mostBytes};
}

IrradianceCache::IrradianceCache(const IrradianceCacheParams& p, int w, int h, int spp,
                                 std::shared_ptr<const BakedLight> baked)
    : params_(p),
      atrous_{
          .sigma_z = p.sigma_z, .sigma_n = p.sigma_n, .sigma_l = p.sigma_l, .sigma_l_diff = p.sigma_l_diff},
      light_({.cell_px = cellEdge(p.cell_px, spp),
              .blend = {.tau = p.tau, .noise = p.noise, .noise_weight = p.noise_weight}},
             static_cast<std::size_t>(gridBytes(p.memory_mib, 1. * w * h))),
      baked_(std::move(baked)),
      estimates_{GridEstimate(w, h), GridEstimate(w, h)},
      filtered_(w, h),
      scratch_(w, h),
      i_prev_(w, h) {}

void IrradianceCache::readBaked(Tile tile, Frame& next) {
  GridEstimate& estimate = estimateOf(next);
  if (baked_ && light_.isAt(next.light))
    baked_->read(tile, *next.surfaces, next.g, estimate);
  else
    estimate.clear(tile);
}

const BounceGrid* IrradianceCache::plan(int spp, const SurfaceFrame& next, const PoolHandle& pool,
                                        StageTimes& times) {
  SurfaceSamples& on = *next.frame.surfaces;
  std::swap(at_, at_prev_);
  std::swap(uncertainty_, uncertainty_prev_);
  std::swap(shadow_detail_, shadow_detail_prev_);
  light_.enter(next.frame.light, frames_);
  SurfaceGrid& grid = light_.current().grid;
  if (light_.changed()) baked_.reset();
  catch_up_ = light_.changed() ? kCatchUp : std::max(catch_up_, 1u) - 1;
  if (frames_++ == 0)
    for (ImageF* plane : {&uncertainty_, &uncertainty_prev_, &shadow_detail_, &shadow_detail_prev_})
      *plane = ImageF(on.columns(), on.height());
  Placement none;
  times[Stage::kTemporal] += grid.place(on, &next.obstacles, pool, light_.changed() ? none : at_prev_, at_);
  times[Stage::kTemporal] += grid.uncertainty({on, next.frame.g, at_}, pool, uncertainty_, &shadow_detail_);
  times[Stage::kTemporal] += pool.forEachRow(on.height(), [&](int y) {
    for (int column = 0; column < on.columns(); ++column)
      on.shadows()[on.indexOf(column, y)].wanted =
          std::max(shadow_detail_.at(column, y), shadow_detail_prev_.at(column, y));
  });
  const bool has_bodies = next.frame.g.body.width() > 0;
  if (has_bodies) wantMovingShadows(on, pool, times);
  // Light at second vertices may have moved.
  const BounceGrid* known = has_bodies ? nullptr : &light_.current().bounces;
  if (!on.needPaths()) return known;
  const auto asked = static_cast<float>(spp);
  const PathPlan paths{.asked = asked,
                       .usual = std::max(asked - params_.grid_paths, 0.5f * asked),
                       .target = params_.target * std::sqrt(2 / asked)};
  times[Stage::kTemporal] += planPaths(paths, uncertainty_, frames_, pool, on);
  return known;
}

void IrradianceCache::wantMovingShadows(SurfaceSamples& on, const PoolHandle& pool, StageTimes& times) {
  light_moved_.resize(on.shadows().size());
  times[Stage::kTemporal] += pool.forEachRow(on.height(), [&](int y) {
    for (int column = 0; column < on.columns(); ++column) {
      const std::size_t i = on.indexOf(column, y);
      if (on[i].light_moves || light_moved_[i]) on.shadows()[i].wanted = SurfaceShadow::kMoves;
      light_moved_[i] = on[i].light_moves;
    }
  });
}

bool IrradianceCache::needsPairs(const FramePair& frames) const {
  return frames.cur.surfaces->hasUncacheable() && frames.prev.surfaces->hasUncacheable() &&
         !frames.cur.stands && catch_up_ == 0;
}

void IrradianceCache::start(const Frame& first, const PoolHandle& pool) {
  StageTimes unused;
  filter(FramePair::first(first), pool, unused);
}

void IrradianceCache::estimate(const FramePair& frames, const PoolHandle& pool, IntensityChange& out,
                               StageTimes& times) {
  filter(frames, pool, times);
  // D[i_{t-1}] is what today's grid estimates for the frame before, not the estimate of then. The filter
  // takes the errors of neighbours for independent, but they share vertices: it lessens them by little.
  const GridEstimate& now = estimateOf(frames.cur);
  times[Stage::kModulate] += pool.forEachRow(i_prev_.height(), [&](int y) {
    const int width = i_prev_.width();
    for (int x = 0; x < width; ++x) i_prev_.at(x, y) = filtered_.i.at(x, y) - filtered_.d.at(x, y);
    std::copy_n(now.var_step.row(y), width, filtered_.var_d.row(y));
  });
  times[Stage::kModulate] +=
      modulate(frames, Demodulation::kAlbedo, 1, filtered_, i_prev_, now.var_i, pool, out);

  fillUncached(frames, pool, out, times);
  addCoats(frames, pool, out, times);
}

void IrradianceCache::addCoats(const FramePair& frames, const PoolHandle& pool, IntensityChange& out,
                               StageTimes& times) {
  if (frames.cur.surfaces->hasCoats() || frames.prev.surfaces->hasCoats()) {
    if (!coats_) coats_ = std::make_unique<CoatChange>(out.dI.width(), out.dI.height());
    coats_->addTo(out, frames, pool, times);
  } else if (coats_) {
    coats_->forget();
  }
}

void IrradianceCache::fillUncached(const FramePair& frames, const PoolHandle& pool, IntensityChange& out,
                                   StageTimes& times) {
  const int width = out.dI.width(), height = out.dI.height();
  const bool all = light_.isNew();
  const auto needed = [&](int x, int y) {
    return all || frames.cur.surfaces->hasUncacheable(x, y) || frames.prev.surfaces->hasUncacheable(x, y);
  };
  if (!svgf_) {
    if (!all && !frames.cur.surfaces->hasUncacheable() && !frames.prev.surfaces->hasUncacheable()) return;
    svgf_ = std::make_unique<Svgf>(SvgfParams{}, width, height);
    uncached_ = std::make_unique<IntensityChange>(width, height);
    svgf_->start(frames.prev, &estimateOf(frames.prev).i, pool);
  }
  svgf_->estimate(frames, &estimateOf(frames.cur).i, pool, *uncached_, times);
  // Its frames differ by the noise of their seeds, even where nothing has changed.
  const bool unchanged = frames.cur.stands && catch_up_ == 0;
  times[Stage::kModulate] += pool.forEachRow(height, [&](int y) {
    for (int x = 0; x < width; ++x) {
      if (!needed(x, y)) continue;
      for (const auto plane : kChangePlanes) (out.*plane).at(x, y) = (*uncached_.*plane).at(x, y);
      if (!unchanged) continue;
      out.dI.at(x, y) = out.var_dI.at(x, y) = 0;
      out.I_prev.at(x, y) = out.I_now.at(x, y);
    }
  });
  if (needsPairs(frames)) {
    if (!paired_) paired_ = std::make_unique<PairedChange>(width, height);
    paired_->estimate(frames, pool, out, times);
  } else if (paired_) {
    paired_->forget();
  }
}

void IrradianceCache::read(const FramePair& frames, const PoolHandle& pool, StageTimes& times) {
  const bool has_bodies = frames.cur.g.body.width() > 0;
  if (!has_bodies && frames.cur.surfaces->needPaths()) light_.current().bounces.add(*frames.cur.surfaces);
  if (at_.empty() && at_prev_.empty()) return;
  const auto* shadows = frames.is_first ? nullptr : &frames.cur.surfaces->shadows();
  const FrameOnGrid cur{*frames.cur.surfaces, frames.cur.g, at_, shadows};
  const FrameOnGrid prev{*frames.prev.surfaces, frames.prev.g, at_prev_, shadows, &SurfaceShadow::before};
  GridEstimate &now = estimateOf(frames.cur), &before = estimateOf(frames.prev);
  SurfaceGrid &grid = light_.current().grid, &grid_prev = light_.previous().grid;
  if (has_bodies) times[Stage::kTemporal] += grid.fade(cur, keptOf, pool);
  const SurfaceGrid::Added added = grid.add(cur, pool);
  const SurfaceGrid::Compared compared = grid.readAdded(added, pool, now);
  times[Stage::kTemporal] += added.time, times[Stage::kVariance] += compared.time;
  if (!frames.is_first) times[Stage::kVariance] += grid_prev.read(prev, pool, before);
  times[Stage::kTemporal] += grid.learn(compared, pool);
  // Points that are seen for the first time have only now been judged.
  const auto again = [&](const SurfaceGrid& from, const FrameOnGrid& frame, GridEstimate& out) {
    times[Stage::kVariance] += from.readAgain(frame, pool, uncertainty_, uncertainty_prev_, out);
  };
  again(grid, cur, now);
  if (!frames.is_first) again(grid_prev, prev, before);
  // The errors of two states of the light have nothing in common.
  if (light_.changed())
    times[Stage::kVariance] += pool.forEachRow(now.i.height(), [&](int y) {
      for (int x = 0; x < now.i.width(); ++x)
        now.var_step.at(x, y) = now.var_i.at(x, y) + before.var_i.at(x, y);
    });
}

// Adds the change of light at surfaces to that which their motion makes.
void IrradianceCache::addLightChange(const FramePair& frames, const PoolHandle& pool, StageTimes& times) {
  if (frames.is_first || frames.cur.surfaces->replays().empty()) return;
  if (!change_) change_ = std::make_unique<LightChange>(i_prev_.width(), i_prev_.height(), light_.params());
  change_->estimate(frames, at_, light_.current().grid, estimateOf(frames.cur), pool, times);
  times[Stage::kModulate] += pool.forEachRow(i_prev_.height(), [&](int y) {
    for (int x = 0; x < i_prev_.width(); ++x)
      if (showsSame(frames, x, y)) filtered_.d.at(x, y) += change_->change().at(x, y);
  });
}

void IrradianceCache::filter(const FramePair& frames, const PoolHandle& pool, StageTimes& times) {
  read(frames, pool, times);
  const GridEstimate &now = estimateOf(frames.cur), &before = estimateOf(frames.prev);
  times[Stage::kVariance] += pool.forEachRow(now.i.height(), [&](int y) {
    for (int x = 0; x < now.i.width(); ++x) {
      filtered_.i.at(x, y) = now.i.at(x, y);
      filtered_.var_i.at(x, y) = now.var_i.at(x, y);
      filtered_.d.at(x, y) = frames.is_first ? 0 : now.i.at(x, y) - before.i.at(x, y);
      filtered_.var_d.at(x, y) = now.var_step.at(x, y);
    }
  });
  const int iterations = baked_ ? std::min(params_.iterations, kBakedIterations) : params_.iterations;
  for (int k = 0; k < iterations; ++k) {
    times[Stage::kAtrous] += atrousIteration(frames, atrous_, 1 << k, filtered_, pool, scratch_);
    std::swap(filtered_, scratch_);
  }
  addLightChange(frames, pool, times);
}

}  // namespace saccade
