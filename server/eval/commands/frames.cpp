// `saccade-eval frames` writes the estimates of a method, frame by frame, or the reference.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "base/default_cache.h"
#include "base/new_folder.h"
#include "base/number_in.h"
#include "eval/bench/arguments.h"
#include "eval/bench/dump.h"
#include "eval/bench/feed_options.h"
#include "eval/bench/interrupt.h"
#include "eval/bench/kept_bake.h"
#include "eval/bench/open_scene.h"
#include "eval/commands/commands.h"
#include "feed/feed.h"
#include "methods/method_spec.h"
#include "saccade/wire/ranges.h"

namespace saccade::eval {
namespace {

struct FramesOptions : FeedOptions {
  std::string frames = "1:21", dump, cache;
  std::vector<std::string> set;
  int reference = 0;
  double bake_error = 0;
  bool features = false;
  int first = 0, last = 0;
};

MethodSpec methodOf(const FramesOptions& o) {
  parseMethod(o.feed.method);  // else a fault is one of its settings
  try {
    return parseMethod(o.feed.method, o.set);
  } catch (const std::exception& fault) {
    throw CLI::ValidationError("--set", fault.what());
  }
}

void resolveMethod(FramesOptions& o) {
  const MethodSpec method = methodOf(o);
  o.feed.params = method.params;
  checkSpp(method, o.feed.spp);
}

void printTimes(const StageTimes& total, double frames) {
  std::printf("CPU ms per frame:");
  double sum = 0, filter = 0;
  for (std::size_t i = 0; i < kStageNames.size(); ++i) {
    const double ms = std::chrono::duration<double, std::milli>(total.cpu[i]).count() / frames;
    std::printf(" %s %.2f", kStageNames[i], ms);
    sum += ms;
    if (i != 0) filter += ms;
  }
  std::printf("  all %.2f; filter / trace %.3f\n", sum, filter / (sum - filter));
}

void runMethod(const FramesOptions& o, std::shared_ptr<const RenderScene> scene, const Trajectory& path,
               TilePool& pool) {
  FeedConfig config = o.feed;
  if (o.bake_error > 0 && findMethod(config.method)->takes_baked)
    config.baked = keptLight(scene, path, config, o.last, o.bake_error, o.cache, sceneName(o.scene), pool);
  Feed feed(scene, path, config, pool);
  StageTimes total;
  Progress progress(o.feed.method, static_cast<double>(o.last));
  for (int t = 1; t <= o.last; ++t) {
    const IntensityChange& change = feed.step(pool);
    total += feed.lastTimes();
    if (t >= o.first && !o.dump.empty()) {
      writeChange(o.dump, t, change);
      if (o.features) writeFeatures(o.dump, t, feed.frames().prev.g);
    }
    progress.add(1);
    if (interrupted()) throw Interrupted{};
  }
  printTimes(total, static_cast<double>(o.last));
}

void runReference(const FramesOptions& o, std::shared_ptr<const RenderScene> scene, const Trajectory& path,
                  TilePool& pool) {
  const int w = o.feed.camera.width, h = o.feed.camera.height;
  constexpr int kChunk = ReferenceRenderer::kChunk;
  const int spp = (o.reference + kChunk - 1) / kChunk * kChunk;
  if (spp != o.reference)
    std::printf(
        "--reference %d is rounded up to %d: references are rendered in steps of %d paths per pixel\n",
        o.reference, spp, kChunk);
  ReferenceRenderer renderer(scene, {o.feed.bounces, scene->channels(), o.feed.jitter}, w, h,
                             scene->description().fov_x_deg, o.cache, pool, o.feed.seed, o.feed.body_paths);
  Progress progress("reference", static_cast<double>(spp) * static_cast<double>(o.last - o.first + 2));
  const auto render = [&](int t) {
    const TimeNs time = frameTime(static_cast<FrameIndex>(t), o.feed.frame_rate_hz);
    return renderer.frame(path.at(time), time, spp, progress);
  };
  ReferenceFrame prev = render(o.first - 1);
  for (int t = o.first; t <= o.last; ++t) {
    ReferenceFrame cur = render(t);
    const ReferenceChange truth(prev, cur);
    if (!o.dump.empty()) writeReference(o.dump, t, truth);
    std::printf("frame %d: %d spp; own error of dI (half of half against half): %.4f relative L1\n", t, spp,
                truth.error());
    prev = std::move(cur);
  }
}

void runFrames(FramesOptions& o) {
  const FrameRange range = parseFrameRange(o.frames);
  o.first = range.first, o.last = range.last;
  resolveMethod(o);
  const auto [scene, path] = open(o);
  TilePool pool(o.threads);
  watchInterrupt();
  try {
    o.reference > 0 ? runReference(o, scene, path, pool) : runMethod(o, scene, path, pool);
  } catch (const Interrupted&) {
    throw std::runtime_error(o.reference > 0
                                 ? "interrupted; the same command continues with what is in " + o.cache
                                 : "interrupted");
  }
}

}  // namespace

void addFramesCommand(CLI::App& app) {
  auto o = std::make_shared<FramesOptions>();
  o->cache = defaultCache();
  auto* c = app.add_subcommand(
      "frames", "run a method or render the reference, and write dI, I_prev and their variances");
  addFeedOptions(*c, *o);
  c->add_option("--method", o->feed.method, "one of: " + methodNames())->capture_default_str();
  c->add_option("--spp", o->feed.spp, "paths per pixel and frame, over both passes")
      ->check(NumberIn(ranges::kSpp.min, ranges::kSpp.max))
      ->capture_default_str();
  c->add_option("--frames", o->frames,
                "A:B, the frames to write; the change of frame 1 is since frame 0. Every run starts at 0")
      ->capture_default_str();
  c->add_flag("--jitter", o->feed.jitter, "start paths anywhere in the pixel, not at its centre");
  c->add_option("--set", o->set, "NAME=NUMBER, a parameter of the method; may be given again");
  c->add_option("--dump", o->dump,
                "folder for dI_N.exr (change into frame N), Iprev_N.exr (frame N - 1) and variance_N.exr, "
                "and halves_N.exr of the reference")
      ->check(CLI::Validator(newFolderFault, ""));
  c->add_option("--reference", o->reference,
                "render the reference instead: paths per pixel, rounded up to a multiple of 64")
      ->check(NumberIn(1, 1 << 20));
  c->add_flag("--features", o->features,
              "write features_N.exr of a method's frame N - 1 too: albedo, emission, normal, depth")
      ->needs("--dump")
      ->excludes("--reference");
  c->add_option("--seed", o->feed.seed, "seed of the random numbers, of a method or of the reference")
      ->check(wholeNumber())
      ->capture_default_str();
  addBakeOption(*c, o->bake_error);
  c->add_option("--cache", o->cache, "folder for reference frames and bakes")
      ->check(CLI::Validator(newFolderFault, ""))
      ->capture_default_str();
  c->callback([o] { runFrames(*o); });
}

}  // namespace saccade::eval
