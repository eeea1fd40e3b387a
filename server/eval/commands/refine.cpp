// `saccade-eval refine` measures refined intervals against frames.
#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "base/default_cache.h"
#include "base/new_folder.h"
#include "base/number_in.h"
#include "eval/bench/arguments.h"
#include "eval/bench/feed_options.h"
#include "eval/bench/interrupt.h"
#include "eval/bench/kept_bake.h"
#include "eval/bench/open_scene.h"
#include "eval/bench/refine_bench.h"
#include "eval/commands/commands.h"
#include "feed/refinement.h"
#include "methods/method_spec.h"
#include "saccade/wire/ranges.h"

namespace saccade::eval {
namespace {

struct RefineCommand : FeedOptions {
  RefineCommand() { trajectory = "truck:1px", size = "346x260"; }

  RefinementSettings refinement;
  int intervals = 4, pieces = 16;
  double bake_error = 0;
  std::string cache = defaultCache();
};

void print(const RefineResult& r, const RefineCommand& o) {
  const double frames = static_cast<double>(o.intervals) * o.pieces, pixels = o.feed.pixels();
  const auto ms = [&](double seconds) { return 1e3 * seconds / frames; };
  std::printf("true events per pixel and fine frame %.4f\n", r.events / pixels / frames);
  std::printf(
      "CPU ms per fine frame: refined %.3f, all fine frames %.3f, the same without a filter %.3f, "
      "two frames per interval %.3f\n",
      ms(r.refined_s), ms(r.fine_s), ms(r.look_ups_s), ms(r.halves_s));
  std::printf(
      "refined: %.3f of all fine frames, %.3f of those without a filter, %.3f of two frames per "
      "interval\n",
      r.refined_s / r.fine_s, r.refined_s / r.look_ups_s, r.refined_s / r.halves_s);
  std::printf(
      "looked up %.4f of pixels and fine frames beside whole frames (%.4f), with %.2f rays each; "
      "without room %.0f pieces\n",
      r.samples / pixels / frames, 1. / o.pieces, r.rays / std::max(r.samples, 1.), r.unsplit);
  const auto row = [&](const char* name, const WindowErrors& e) {
    std::printf("%-24s false %.4f, missed %.4f, time error %.3f fine frames\n", name, e.false_share,
                e.missed_share, e.time * o.pieces);
  };
  row("refined:", r.refined_errors);
  row("fine frames, no filter:", r.look_up_errors);
  row("two frames per interval:", r.half_errors);
  std::printf("time error against that of two frames: %.3f\n", r.refined_errors.time / r.half_errors.time);
}

void measure(RefineCommand& o, const std::shared_ptr<const RenderScene>& scene, const Trajectory& path) {
  if (o.bake_error > 0) {
    TilePool pool(o.threads);
    o.feed.baked =
        keptLight(scene, path, o.feed, o.intervals, o.bake_error, o.cache, sceneName(o.scene), pool);
  }
  std::printf("%s %s %s, %d intervals of %d fine frames\n", o.scene.c_str(), o.size.c_str(),
              o.trajectory.c_str(), o.intervals, o.pieces);
  print(measureRefinement({scene, path, o.feed, o.intervals, o.pieces}), o);
}

void run(RefineCommand& o) {
  if (o.pieces % 2 != 0) throw CLI::ValidationError("--pieces", "must be an even number");
  const MethodSpec method = parseMethod(o.feed.method);
  o.feed.params = method.params;
  checkSpp(method, o.feed.spp);
  o.feed.refinement = o.refinement;
  if (const std::string fault = refinementFault(o.feed); !fault.empty())
    throw CLI::ValidationError("--method", fault);
  const auto [scene, path] = open(o);
  watchInterrupt();
  try {
    measure(o, scene, path);
  } catch (const Interrupted&) {
    throw std::runtime_error("interrupted");
  }
}

}  // namespace

void addRefineCommand(CLI::App& app) {
  auto o = std::make_shared<RefineCommand>();
  auto* c = app.add_subcommand(
      "refine",
      "measure refined intervals against frames: CPU time, and events against those of fine frames");
  addFeedOptions(*c, *o);
  c->add_option("--method", o->feed.method, "one that knows light between frames")->capture_default_str();
  c->add_option("--spp", o->feed.spp, "paths per pixel and frame")
      ->check(NumberIn(ranges::kSpp.min, ranges::kSpp.max))
      ->capture_default_str();
  c->add_option("--intervals", o->intervals, "intervals: --rate tells their length")
      ->check(NumberIn(1, 1000))
      ->capture_default_str();
  c->add_option("--pieces", o->pieces, "fine frames per interval, an even number")
      ->check(NumberIn(2, 64))
      ->capture_default_str();
  c->add_option("--finest", o->refinement.finest_px, "motion within the shortest pieces, pixels")
      ->check(NumberIn(1e-3, 1e3))
      ->capture_default_str();
  c->add_option("--threshold", o->refinement.threshold, "of the sensor, log brightness")
      ->check(NumberIn(1e-3, 10.))
      ->capture_default_str();
  addBakeOption(*c, o->bake_error);
  c->add_option("--cache", o->cache, "folder for bakes")
      ->check(CLI::Validator(newFolderFault, ""))
      ->capture_default_str();
  c->callback([o] { run(*o); });
}

}  // namespace saccade::eval
