#include "methods/known_light.h"

#include <algorithm>
#include <utility>

#include "base/scratch.h"

namespace saccade {
namespace {

// The share of what is known of a point that holds in the next frame. Replays may tell how light has
// changed, or nothing does.
float keptWithReplays(const SurfacePoint& point) {
  return point.light_moves ? 0.97f : 1;
}
float keptWithoutReplays(const SurfacePoint& point) {
  return point.light_moves ? 0.9f : 1;
}

}  // namespace

KnownLight::KnownLight(const GridParams& params, std::size_t memory, std::shared_ptr<const BakedLight> baked,
                       int width, int height, bool refined)
    : refined_(refined),
      states_(params, memory),
      baked_(std::move(baked)),
      estimates_{GridEstimate(width, height), GridEstimate(width, height)} {}

void KnownLight::readBaked(Tile tile, Frame& next) {
  GridEstimate& estimate = estimateOf(next);
  if (baked_ && states_.isAt(next.light))
    baked_->read(tile, *next.surfaces, next.g, estimate);
  else
    estimate.clear(tile);
}

void KnownLight::enter(const SurfaceFrame& next, const PoolHandle& pool, StageTimes& times) {
  SurfaceSamples& on = *next.frame.surfaces;
  std::swap(at_, at_prev_);
  std::swap(uncertainty_, uncertainty_prev_);
  std::swap(shadow_detail_, shadow_detail_prev_);
  states_.enter(next.frame.light, frames_);
  if (changed()) baked_.reset();
  if (frames_++ == 0)
    for (ImageF* plane : {&uncertainty_, &uncertainty_prev_, &shadow_detail_, &shadow_detail_prev_})
      *plane = ImageF(on.columns(), on.height());
  Placement none;
  times[Stage::kTemporal] += state().grid.place(on, &next.obstacles, pool, changed() ? none : at_prev_, at_);
  const FrameOnGrid frame{on, next.frame.g, at_};
  times[Stage::kTemporal] += state().grid.uncertainty(frame, pool, uncertainty_, &shadow_detail_);
  wantShadows(on, pool, times);
  if (next.frame.g.hasBodies()) wantMovingShadows(on, pool, times);
}

void KnownLight::wantShadows(SurfaceSamples& on, const PoolHandle& pool, StageTimes& times) {
  constexpr float kNone = -1;  // where no rays start
  const bool asks = on.needPaths() || on.nearShadows(), asked = std::exchange(asks_rays_, asks);
  on.setWantShadows(asks && asked);
  if (!asks) return;
  times[Stage::kTemporal] += pool.forEachRow(on.height(), [&](int y) {
    for (int column = 0; column < on.columns(); ++column) {
      const std::size_t i = on.indexOf(column, y);
      float &wanted = on.shadows()[i].wanted, &detail = shadow_detail_.at(column, y);
      if (on[i].baked) detail = on[i].near_shadow ? wanted : kNone;
      const float before = shadow_detail_prev_.at(column, y);
      wanted = std::min(detail, before) == kNone ? 0 : std::max(detail, before);
    }
  });
}

void KnownLight::wantMovingShadows(SurfaceSamples& on, const PoolHandle& pool, StageTimes& times) {
  on.setWantShadows(true);
  light_moved_.resize(on.shadows().size());
  times[Stage::kTemporal] += pool.forEachRow(on.height(), [&](int y) {
    for (int column = 0; column < on.columns(); ++column) {
      const std::size_t i = on.indexOf(column, y);
      if (on[i].light_moves || light_moved_[i]) on.shadows()[i].wanted = SurfaceShadow::kMoves;
      light_moved_[i] = on[i].light_moves;
    }
  });
}

const ImageF& KnownLight::errorOfChange(const SurfaceFrame& next, const PoolHandle& pool, StageTimes& times) {
  LightState& light = state();
  if (error_of_change_.width() == 0) error_of_change_ = ImageF(uncertainty_.width(), uncertainty_.height());
  light.changes.follow(light.grid);
  times[Stage::kTemporal] += light.grid.errorOfChange({*next.frame.surfaces, next.frame.g, at_},
                                                      light.changes, pool, error_of_change_);
  return error_of_change_;
}

void KnownLight::read(const FramePair& frames, const PoolHandle& pool, StageTimes& times) {
  readGrid(frames, pool, times);
  readBakedShadows(frames, pool, times);
}

void KnownLight::readGrid(const FramePair& frames, const PoolHandle& pool, StageTimes& times) {
  const bool has_bodies = frames.cur.g.hasBodies();
  if (!has_bodies && frames.cur.surfaces->needPaths()) state().bounces.add(*frames.cur.surfaces);
  if (at_.empty() && at_prev_.empty()) return;
  const auto* shadows =
      frames.is_first || !frames.cur.surfaces->wantShadows() ? nullptr : &frames.cur.surfaces->shadows();
  const FrameOnGrid cur{*frames.cur.surfaces, frames.cur.g, at_, shadows};
  const FrameOnGrid prev{*frames.prev.surfaces, frames.prev.g, at_prev_, shadows, &SurfaceShadow::before};
  GridEstimate &now = estimateOf(frames.cur), &before = estimateOf(frames.prev);
  SurfaceGrid &grid = states_.current().grid, &grid_prev = states_.previous().grid;
  if (has_bodies) {
    const auto kept = cur.on.changes().empty() ? keptWithoutReplays : keptWithReplays;
    times[Stage::kTemporal] += grid.fade(cur, kept, pool);
  }
  const SurfaceGrid::Added added = grid.add(cur, pool);
  const SurfaceGrid::Compared compared = grid.readAdded(added, pool, now);
  times[Stage::kTemporal] += added.time, times[Stage::kVariance] += compared.time;
  if (!frames.is_first) times[Stage::kVariance] += grid_prev.read(prev, pool, before);
  times[Stage::kTemporal] += grid.learn(compared, pool);
  // Points that are seen for the first time have only now been judged. readPoints() finds what all of them
  // show now.
  const auto again = [&](const SurfaceGrid& from, const FrameOnGrid& frame, GridEstimate& out) {
    times[Stage::kVariance] += refined_ ? from.read(frame, pool, out)
                                        : from.readAgain(frame, pool, uncertainty_, uncertainty_prev_, out);
  };
  again(grid, cur, now);
  if (!frames.is_first) again(grid_prev, prev, before);
  // The errors of two states of the light have nothing in common.
  if (changed())
    times[Stage::kVariance] += pool.forEachRow(now.i.height(), [&](int y) {
      for (int x = 0; x < now.i.width(); ++x)
        now.var_step.at(x, y) = now.var_i.at(x, y) + before.var_i.at(x, y);
    });
}

void KnownLight::readPoints(std::span<const PointSample> at, std::span<PlaceLight> out) const {
  if (baked_)
    baked_->read(at, out);
  else
    std::ranges::fill(out, PlaceLight{});
  const auto isUnknown = [](const PlaceLight& light) { return !light.known; };
  if (std::ranges::any_of(out, isUnknown)) states_.current().grid.readPoints(at, out);
  for (std::size_t k = 0; k < out.size(); ++k)
    if (out[k].known && at[k].light_moves && at[k].place.unoccluded > 0)
      out[k].shadow = SurfaceShadow::kMoves, out[k].shadow_visible = true;
}

void KnownLight::readBakedShadows(const FramePair& frames, const PoolHandle& pool, StageTimes& times) {
  const SurfaceSamples &now = *frames.cur.surfaces, &before = *frames.prev.surfaces;
  if (!baked_ || frames.is_first || !(now.wantShadows() || before.wantShadows())) return;
  const auto* shadows = now.wantShadows() ? &now.shadows() : nullptr;
  times[Stage::kVariance] += pool.forEachRow(now.height(), [&](int y) {
    const Scratch<std::vector<BakedLight::Pixel>> pixels;
    pixels->clear();
    // Of the frame before, also those that have the visibility by its own rays.
    for (int x = 0; x < frames.cur.width(); ++x)
      if (now.wantsShadows(x, y) || before.wantsShadows(x, y)) pixels->push_back({x, y});
    const auto readAgain = [&](const Frame& frame, RayVisibility SurfaceShadow::*visibility) {
      baked_->readAgain(*pixels, *frame.surfaces, frame.g, {shadows, visibility}, estimateOf(frame));
    };
    readAgain(frames.cur, &SurfaceShadow::now), readAgain(frames.prev, &SurfaceShadow::before);
  });
}

}  // namespace saccade
