#include "feed/feed.h"

#include <algorithm>

#include "base/quantile.h"
#include "base/thread_time.h"
#include "feed/refinement.h"
#include "methods/round_method.h"
#include "render/primary/sub_pixel.h"
#include "render/render_pixels.h"

namespace saccade {
namespace {

const MethodInfo& methodOf(const FeedConfig& config) {
  const MethodInfo* info = findMethod(config.method);
  SACCADE_CHECK(info != nullptr);
  return *info;
}

RenderSettings settingsOf(const FeedConfig& config, const RenderScene& scene) {
  return {config.bounces, config.monochrome ? 1 : scene.channels(), config.jitter};
}

// `seeds` are of all rounds.
std::chrono::nanoseconds renderRounds(const RenderSettings& settings, const PixelContext& view,
                                      const SeedPlan& seeds, RoundMethod& method, const PoolHandle& pool,
                                      Frame& out) {
  std::chrono::nanoseconds time{0};
  SeedPlan round = seeds;
  round.all = seeds.spp2;
  while ((round.spp2 = method.nextRound(seeds.spp2, pool)) > 0) {
    time += renderPixels(settings, view, round, method.wanted(), pool, out);
    method.take(out, pool);
    round.before += round.spp2;
  }
  return time;
}

}  // namespace

Feed::Feed(std::shared_ptr<const RenderScene> scene, Trajectory path, const FeedConfig& config,
           const PoolHandle& pool)
    : Feed(std::move(scene), std::move(path), config,
           methodOf(config).make({config.params, config.camera.width, config.camera.height, config.spp,
                                  config.baked, config.refinement.has_value()}),
           methodOf(config).seeds(config.params), pool) {}

Feed::Feed(std::shared_ptr<const RenderScene> scene, Trajectory path, const FeedConfig& config,
           std::unique_ptr<Method> method, SeedPlanner seeds, const PoolHandle& pool)
    : config_(config),
      lens_(config.camera),
      posed_{PosedScene(scene, config.body_paths), PosedScene(scene, config.body_paths)},
      path_(std::move(path)),
      renderer_(settingsOf(config, *scene)),
      method_(std::move(method)),
      seeds_(seeds),
      frames_(config.camera.width, config.camera.height,
              method_->onSurfaces() ? (config.jitter ? kSubPixels : 1) : 0),
      changes_{IntensityChange(config.camera.width, config.camera.height),
               IntensityChange(config.camera.width, config.camera.height)} {
  if (config.refinement) refinement_ = std::make_unique<Refinement>(config, scene);
  lens_.tabulate();
  render(TimeNs{0}, pool);
  method_->start(frames_.current(), pool);
}

Feed::~Feed() = default;

const IntensityChange& Feed::stepTo(TimeNs t, const PoolHandle& pool) {
  const auto began = threadCpuTime() + TilePool::criticalPathTime();
  times_ = {};
  held_ = false;
  frames_.swap();
  render(t, pool);
  const FramePair frames = frames_.pair();
  IntensityChange& change = nextChange(frames.prev.time, frames.cur.time);
  method_->estimate(frames, pool, change, times_);
  if (refinement_) refine(pool, change);
  critical_path_ = threadCpuTime() + TilePool::criticalPathTime() - began;
  return change;
}

IntensityChange& Feed::nextChange(TimeNs t0, TimeNs t1) {
  IntensityChange& change = changes_[++steps_ % 2];
  change.t0 = t0, change.t1 = t1;
  change.frame = steps_;
  return change;
}

bool Feed::standsUntil(TimeNs t) const {
  const TimeNs now = frames_.pair().cur.time;
  const PosedBodies* bodies = posed_[0].bodies();
  const auto stands = [&](const Trajectory& path) { return path.at(t) == path.at(now); };
  return posed_[0].strengths().areSteady() && stands(path_) &&
         (!bodies || std::ranges::all_of(bodies->paths(), stands));
}

const IntensityChange& Feed::holdTo(TimeNs t) {
  SACCADE_CHECK(steps_ > 0);
  const IntensityChange& last = change();
  IntensityChange& change = nextChange(last.t1, t);
  change.I_prev.copyFrom(last.I_now), change.I_now.copyFrom(last.I_now);
  change.var_I_prev.copyFrom(last.var_I_prev);
  change.dI.fill(0), change.var_dI.fill(0);
  change.updates.clear();
  frames_.current().time = t;
  times_ = {}, critical_path_ = {};
  held_ = true;
  return change;
}

void Feed::measureMotion(std::span<const TimeNs> times, std::span<double> px) {
  const Frame& frame = frames_.pair().cur;
  const PosedScene& posed = posed_[frame.index % 2];
  motion_.look(frame, cameraAt(frame.time), posed);
  for (std::size_t i = 0; i < times.size(); ++i) px[i] = motion_.moveTo(times[i], cameraAt(times[i]), posed);
}

void Feed::steer(const FeedKeys& keys) {
  path_.append(keys.camera);
  for (PosedScene& posed : posed_)
    for (const BodyKey& body : keys.bodies) posed.append(body.body, body.key);
  if (refinement_) refinement_->steer(keys);
}

void Feed::render(TimeNs t, const PoolHandle& pool) {
  Frame& frame = frames_.current();
  frame.index = next_++;
  frame.time = t;
  const TimeNs time_prev = frame.index == 0 ? t : frames_.pair().prev.time;
  const Camera camera = cameraAt(frame.time), prev = cameraAt(time_prev);
  PosedScene& posed = posed_[frame.index % 2];
  posed.setTime(frame.time);
  const PosedScene& posed_prev = frame.index == 0 ? posed : posed_[(frame.index + 1) % 2];
  frame.stands =
      frame.index > 0 && path_.at(frame.time) == path_.at(time_prev) && posed.posesEqual(posed_prev);
  const PixelContext view({posed, camera}, {posed_prev, prev});
  const SeedPlan seeds = seeds_(config_.seed, frame.index, config_.spp);
  SurfaceMethod* method = method_->onSurfaces();
  if (!method) {
    RoundMethod* rounds = method_->inRounds();
    times_[Stage::kTrace] +=
        rounds ? renderRounds(settingsOf(config_, scene()), view, seeds, *rounds, pool, frame)
               : renderer_.render(view, seeds, pool, frame);
    return;
  }
  const SurfaceFrame next =
      renderer_.renderSurfaces(view, pool, frame, [&](Tile tile) { method->readBaked(tile, frame); });
  const BounceGrid* known = method->plan(config_.spp, next, pool, times_);
  times_[Stage::kTrace] += next.time + renderer_.renderPaths(view.now, seeds, next, known, pool);
  const Frame& before = frames_.pair().prev;
  if (frame.index == 0) return;
  if (posed.bodies()) times_[Stage::kTrace] += renderer_.renderReplays(view, seeds, pool, frame);
  times_[Stage::kTrace] += renderer_.traceShadows(view, config_.spp, frame, before, pool);
  if (method->needsPairs({frame, before}))
    times_[Stage::kTrace] += renderer_.renderPairs(view, seeds, before, known, pool, frame);
}

void Feed::refine(const PoolHandle& pool, IntensityChange& change) {
  change.updates.clear(), refined_ = {};
  const FramePair frames = frames_.pair();
  if (frames.cur.stands || frames.cur.light != frames.prev.light) return;
  const Refinement::Interval interval{frames,
                                      posed_[frames.cur.index % 2],
                                      renderer_.motion(),
                                      bodiesReach(frames),
                                      *method_->onSurfaces(),
                                      renderer_.shadowRays(),
                                      [this](TimeNs t) { return cameraAt(t); }};
  times_[Stage::kRefine] += refinement_->refine(interval, pool, change);
  refined_ = refinement_->lastCounts();
}

// In a scene without bodies the motion vectors tell all.
float Feed::bodiesReach(const FramePair& frames) {
  const PosedScene& before = posed_[frames.prev.index % 2];
  if (!before.bodies()) return 0;
  motion_.look(frames.prev, cameraAt(frames.prev.time), before);
  return static_cast<float>(motion_.moveTo(frames.cur.time, cameraAt(frames.cur.time), before));
}

Camera Feed::cameraAt(TimeNs t) const {
  return {scene().inScene(path_.at(t)), lens_};
}

FeedInterval Feed::interval() const {
  const IntensityChange& done = change();
  const FramePair pair = frames(), shown = held_ ? FramePair{pair.cur, pair.cur} : pair;
  return {done, RenderedInterval{shown, cameraAt(done.t1), cameraAt(done.t0), path_,
                                 posed_[shown.cur.index % 2], posed_[shown.prev.index % 2]}};
}

PixelSpeed Feed::pixelSpeed(FrameIndex frames) const {
  return measurePixelSpeed(scene(), path_, config_, frames);
}

float Feed::firstFrameLuminance(double fraction) const {
  const Frame& frame = frames_.pair().cur;
  SACCADE_CHECK(frame.index == 0);
  std::vector<float> values;
  for (int y = 0; y < frame.height(); ++y) {
    for (int x = 0; x < frame.width(); ++x) {
      const FrameSamples& s = frame.samples;
      values.push_back(s.spp1 > 0 ? 0.5f * (s.I1.at(x, y) + s.I2.at(x, y)) : s.I2.at(x, y));
    }
  }
  return quantile(values, fraction);
}

}  // namespace saccade
