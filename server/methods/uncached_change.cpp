#include "methods/uncached_change.h"

#include <algorithm>

namespace saccade {
namespace {

// Frames after a change of light, until 3 % of it are missing in a history of SVGF.
constexpr std::uint32_t kCatchUp = 32;

}  // namespace

void UncachedChange::next(bool light_changed) {
  catch_up_ = light_changed ? kCatchUp : std::max(catch_up_, 1u) - 1;
}

bool UncachedChange::needsPairs(const FramePair& frames) const {
  return frames.cur.surfaces->hasUncacheable() && frames.prev.surfaces->hasUncacheable() &&
         !frames.cur.stands && catch_up_ == 0;
}

void UncachedChange::estimate(const FramePair& frames, bool all, const ImageF& now, const ImageF& before,
                              const PoolHandle& pool, IntensityChange& out, StageTimes& times) {
  const int width = out.dI.width(), height = out.dI.height();
  if (!svgf_) {
    if (!all && !frames.cur.surfaces->hasUncacheable() && !frames.prev.surfaces->hasUncacheable()) return;
    svgf_ = std::make_unique<Svgf>(SvgfParams{}, width, height);
    by_svgf_ = std::make_unique<IntensityChange>(width, height);
    svgf_->start(frames.prev, &before, pool);
  }
  bySvgf(frames, all, now, pool, out, times);
  if (needsPairs(frames)) {
    if (!paired_) paired_ = std::make_unique<PairedChange>(width, height);
    paired_->estimate(frames, pool, out, times);
  } else if (paired_) {
    paired_->forget();
  }
}

void UncachedChange::bySvgf(const FramePair& frames, bool all, const ImageF& now, const PoolHandle& pool,
                            IntensityChange& out, StageTimes& times) {
  svgf_->estimate(frames, &now, pool, *by_svgf_, times);
  const auto needed = [&](int x, int y) {
    return all || frames.cur.surfaces->hasUncacheable(x, y) || frames.prev.surfaces->hasUncacheable(x, y);
  };
  // Its frames differ by the noise of their seeds, even where nothing has changed.
  const bool unchanged = frames.cur.stands && catch_up_ == 0;
  times[Stage::kModulate] += pool.forEachRow(out.dI.height(), [&](int y) {
    for (int x = 0; x < out.dI.width(); ++x) {
      if (!needed(x, y)) continue;
      for (const auto plane : kChangePlanes) (out.*plane).at(x, y) = (*by_svgf_.*plane).at(x, y);
      if (!unchanged) continue;
      out.dI.at(x, y) = out.var_dI.at(x, y) = 0;
      out.I_prev.at(x, y) = out.I_now.at(x, y);
    }
  });
}

}  // namespace saccade
