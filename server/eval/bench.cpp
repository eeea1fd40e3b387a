#include "eval/bench.h"

#include "eval/open_scene.h"

namespace saccade {

Bench::Bench(const BenchSetup& setup, TilePool& pool)
    : setup_(setup),
      pool_(pool),
      scene_(openScene(setup.scene)),
      path_(openTrajectory(setup.scene, setup.trajectory, *scene_)) {
  ReferenceRenderer renderer(scene_, setup.bounces, setup.width, setup.height,
                             scene_->description().fov_x_deg, setup.cache, pool);
  Progress progress("reference of " + setup.scene, 2.0 * setup.reference_spp);
  const auto at = [&](int t) {
    const TimeNs time = frameTime(static_cast<FrameIndex>(t), setup.frame_rate_hz);
    return renderer.frame(path_.at(time), time, setup.reference_spp, progress);
  };
  const ReferenceFrame prev = at(setup.frame - 1);
  truth_ = std::make_unique<ReferenceChange>(prev, at(setup.frame));
}

BenchRun Bench::run(const std::string& method, int spp, const ParamValues& params, std::uint64_t seed) const {
  FeedConfig config;
  config.width = setup_.width, config.height = setup_.height;
  config.fov_x_deg = scene_->description().fov_x_deg;
  config.frame_rate_hz = setup_.frame_rate_hz;
  config.method = method, config.params = params, config.spp = spp;
  config.bounces = setup_.bounces, config.seed = seed;
  Feed feed(scene_, path_, config, pool_);
  StageTimes total;
  for (int t = 1; t <= setup_.frame; ++t) {
    feed.step();
    total += feed.lastTimes();
    if (interrupted()) throw Interrupted{};
  }
  BenchRun run(setup_.width, setup_.height);
  const IntensityChange& change = feed.change();
  run.change.t0 = change.t0, run.change.t1 = change.t1, run.change.frame = change.frame;
  run.change.dI.copyFrom(change.dI);
  run.change.I_prev.copyFrom(change.I_prev);
  run.change.I_now.copyFrom(change.I_now);
  run.change.var_dI.copyFrom(change.var_dI);
  run.change.var_I_prev.copyFrom(change.var_I_prev);
  const auto ms = [&](std::chrono::nanoseconds t) {
    return std::chrono::duration<double, std::milli>(t).count() / setup_.frame;
  };
  for (const auto stage : total.cpu) run.cpu_ms += ms(stage);
  run.trace_ms = ms(total[Stage::kTrace]);
  return run;
}

}  // namespace saccade
