#include "eval/bench/bench.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/quantile.h"
#include "eval/bench/interrupt.h"
#include "eval/bench/kept_bake.h"
#include "eval/bench/open_scene.h"
#include "eval/bench/steady_path.h"
#include "eval/metrics/for_each_pixel.h"
#include "render/features/simplify.h"

namespace saccade::eval {
namespace {

double medianMotion(const GBuffer& g) {
  std::vector<double> lengths;
  forEachPixel(g.z, [&](int x, int y) {
    if (g.z.at(x, y) < kMissDepth) lengths.push_back(std::hypot(g.motion_x.at(x, y), g.motion_y.at(x, y)));
  });
  return lengths.empty() ? 0 : quantile(lengths, 0.5);
}

double surfaceShare(const GBuffer& g) {
  double hits = 0;
  forEachPixel(g.z, [&](int x, int y) { hits += g.z.at(x, y) < kMissDepth; });
  return hits / (static_cast<double>(g.z.width()) * g.z.height());
}

std::shared_ptr<const RenderScene> openSceneOf(const BenchSetup& setup) {
  auto scene = openMovingScene(setup.scene, parseObjects(setup.objects), setup.animation);
  if (setup.mips) return scene;
  return std::make_shared<RenderScene>(simplified(scene->description(), {SceneFeature::kMipFiltering}));
}

}  // namespace

Bench::Bench(const BenchSetup& setup, TilePool& pool) : Bench(setup, openSceneOf(setup), pool) {}

Bench::Bench(const BenchSetup& setup, std::shared_ptr<const RenderScene> scene, TilePool& pool)
    : setup_(setup),
      pool_(pool),
      scene_(std::move(scene)),
      path_(openTrajectory(setup.scene, setup.trajectory, *scene_, feedConfig())) {
  SACCADE_CHECK(setup.first >= 1 && setup.first <= setup.last);
  if (setup.px_per_frame > 0) {
    setup_.frame_rate_hz =
        kMotionRateHz * kMotionPxPerFrame / setup.px_per_frame * (setup.width / kMotionWidth);
    const TimeNs at = frameTime(static_cast<FrameIndex>(setup.last), setup_.frame_rate_hz);
    if (setup.trajectory == "orbit")
      path_ = turningThrough(path_, at);
    else if (setup.trajectory != "shake")
      path_ = straightThrough(path_, at);
  }
  if (setup_.reference_spp > 0) renderTruth();
}

Bench::Bench(const Bench& other, std::shared_ptr<const RenderScene> scene, int bounces)
    : setup_(other.setup_), pool_(other.pool_), scene_(std::move(scene)), path_(other.path_) {
  setup_.bounces = bounces;
  if (setup_.reference_spp > 0) renderTruth();
}

Bench::Bench(const Bench& other, bool jitter)
    : setup_(other.setup_), pool_(other.pool_), scene_(other.scene_), path_(other.path_) {
  setup_.jitter = jitter;
  if (setup_.reference_spp > 0) renderTruth();
}

// A feed of a single path per pixel gives the features: its frames know where surfaces were.
Feed Bench::features() const {
  FeedConfig config = feedConfig();
  config.method = "pt", config.spp = 1, config.bounces = 0;
  return Feed(scene_, path_, config, pool_);
}

BenchView Bench::view() const {
  Feed features = this->features();
  BenchView view;
  for (int t = 1; t <= setup_.last; ++t) {
    features.step(pool_);
    if (t >= setup_.first) view.surface = std::min(view.surface, surfaceShare(features.frames().cur.g));
    if (interrupted()) throw Interrupted{};
  }
  view.px_per_frame = medianMotion(features.frames().cur.g);
  return view;
}

void Bench::renderTruth() {
  const int w = setup_.width, h = setup_.height;
  const double fov = scene_->description().fov_x_deg;
  ReferenceRenderer reference(scene_, {setup_.bounces, scene_->channels(), setup_.jitter}, w, h, fov,
                              setup_.cache, pool_, 0, feedConfig().body_paths);
  Progress progress("reference of " + setup_.scene,
                    static_cast<double>(setup_.last - setup_.first + 2) * setup_.reference_spp);
  Feed features = this->features();
  for (int t = 1; t < setup_.first; ++t) features.step(pool_);
  const auto frame = [&](int t) {
    const TimeNs time = frameTime(static_cast<FrameIndex>(t), setup_.frame_rate_hz);
    return reference.frame(path_.at(time), time, setup_.reference_spp, progress);
  };
  ReferenceFrame prev = frame(setup_.first - 1);
  for (int t = setup_.first; t <= setup_.last; ++t) {
    ReferenceFrame cur = frame(t);
    const IntensityChange& at = features.step(pool_);
    truth_.push_back({{prev, cur}, findRegions(features.frames().cur.g, features.frames().prev.g)});
    IntensityChange& change = truth_.back().change;
    change.t0 = at.t0, change.t1 = at.t1, change.frame = at.frame;
    prev = std::move(cur);
  }
  median_px_ = medianMotion(features.frames().cur.g);
}

double Bench::referenceError() const {
  double sum = 0;
  for (const Truth& t : truth_) sum += t.error();
  return sum / static_cast<double>(truth_.size());
}

FeedConfig Bench::feedConfig() const {
  FeedConfig config;
  config.camera = pinhole(scene_->description().fov_x_deg, setup_.width, setup_.height);
  config.frame_rate_hz = setup_.frame_rate_hz;
  config.bounces = setup_.bounces;
  config.jitter = setup_.jitter;
  config.body_paths = openPaths(scene_->description(), parseObjects(setup_.objects), setup_.frame_rate_hz);
  return config;
}

std::shared_ptr<const BakedLight> Bench::baked() const {
  if (!baked_)
    baked_ = keptLight(scene_, path_, feedConfig(), setup_.last, setup_.bake_error, setup_.cache,
                       setup_.scene, pool_);
  return baked_;
}

BenchRun Bench::run(const MethodSpec& method, int spp, std::uint64_t seed,
                    const std::function<void(const IntensityChange&)>& each) const {
  FeedConfig config = feedConfig();
  config.method = method.name, config.params = method.params, config.spp = spp, config.seed = seed;
  if (setup_.bake_error > 0 && findMethod(method.name)->takes_baked) config.baked = baked();
  Feed feed(scene_, path_, config, pool_);
  const auto ms = [](std::chrono::nanoseconds t) {
    return std::chrono::duration<double, std::milli>(t).count();
  };
  BenchRun run;
  for (int t = 1; t <= setup_.last; ++t) {
    const IntensityChange& change = feed.step(pool_);
    run.frame_ms.push_back(ms(feed.lastTimes().total()));
    run.trace_ms += ms(feed.lastTimes()[Stage::kTrace]) / setup_.last;
    if (each) each(change);
    if (t >= setup_.first) run.changes.emplace_back(setup_.width, setup_.height).copyFrom(change);
    if (interrupted()) throw Interrupted{};
  }
  run.cpu_ms = std::accumulate(run.frame_ms.begin(), run.frame_ms.end(), 0.0) / setup_.last;
  return run;
}

}  // namespace saccade::eval
