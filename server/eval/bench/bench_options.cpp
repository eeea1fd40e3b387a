#include "eval/bench/bench_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>

#include "base/cpu_name.h"
#include "base/default_cache.h"
#include "base/new_folder.h"
#include "base/number_in.h"
#include "eval/bench/arguments.h"
#include "eval/bench/feed_options.h"
#include "eval/bench/open_scene.h"
#include "saccade/wire/ranges.h"

namespace saccade::eval {

namespace {

void addCameraOptions(CLI::App& app, BenchOptions& o) {
  app.add_option(kTrajectoryFlag, o.setup.trajectory, trajectoryHelp())
      ->check(readBy(checkMotion))
      ->capture_default_str();
  app.add_option("--rate", o.setup.frame_rate_hz, "frames per second")
      ->check(NumberIn(ranges::kFrameRate.min, ranges::kFrameRate.max))
      ->capture_default_str();
  app.add_option("--frames", o.frames, "A:B, the frames to score; every run starts at 0")
      ->capture_default_str();
}

}  // namespace

std::string BenchOptions::text() const {
  std::ostringstream text;
  text << "cpu=\"" << cpuName() << '"';
  if (camera) text << " trajectory=\"" << setup.trajectory << '"';
  text << " size=" << setup.width << 'x' << setup.height;
  if (camera && setup.px_per_frame > 0)
    text << " px_per_frame=" << setup.px_per_frame;
  else if (camera)
    text << " rate_hz=" << setup.frame_rate_hz;
  if (camera) text << " frames=" << setup.first << ':' << setup.last;
  for (const std::string& object : setup.objects) text << " object=\"" << object << '"';
  if (!setup.animation.empty()) text << " animation=\"" << setup.animation << '"';
  text << " bounces=" << setup.bounces;
  if (setup.jitter) text << " jitter=1";
  if (setup.bake_error > 0) text << " bake=" << setup.bake_error;
  if (threshold > 0) text << " threshold=" << threshold;
  text << " bias=" << bias << " reference_spp=" << setup.reference_spp;
  if (repeats > 0) text << " repeats=" << repeats;
  return text.str();
}

void addBenchOptions(CLI::App& app, BenchOptions& o) {
  o.parsed = &app;
  o.setup.cache = defaultCache();
  if (o.camera) addCameraOptions(app, o);
  addObjectOption(app, o.setup.objects);
  addAnimationOption(app, o.setup.animation);
  app.add_option("--size", o.size, "WIDTHxHEIGHT, pixels")->capture_default_str();
  app.add_flag(
      "--jitter", o.setup.jitter,
      "start paths anywhere in the pixel, not at its centre; the reference is the mean over the pixel");
  app.add_option("--bounces", o.setup.bounces, "indirect bounces")
      ->check(NumberIn(ranges::kBounces.min, ranges::kBounces.max))
      ->capture_default_str();
  app.add_option("--reference", o.setup.reference_spp,
                 "paths per pixel of the reference, rounded up to a multiple of 64")
      ->check(NumberIn(64, 1 << 20))
      ->capture_default_str();
  if (o.repeats > 0) {
    app.add_option("--repeats", o.repeats, "runs with different seeds")
        ->check(NumberIn(1, 1000))
        ->capture_default_str();
  }
  if (o.threshold > 0) {
    app.add_option("--threshold", o.threshold, "contrast threshold of both polarities, natural log units")
        ->check(NumberIn(ranges::kThreshold.min, ranges::kThreshold.max))
        ->capture_default_str();
  }
  app.add_option("--bias", o.bias, "I_eps, scene luminance")
      ->check(NumberIn(ranges::kBias.min, ranges::kBias.max))
      ->capture_default_str();
  addBakeOption(app, o.setup.bake_error);
  app.add_option("--cache", o.setup.cache, "folder for reference frames and bakes")
      ->check(CLI::Validator(newFolderFault, ""))
      ->capture_default_str();
  app.add_flag("--quick", o.quick,
               std::string(o.camera ? "half the size and rate, fewer frames, "
                                    : "half the size, fewer frames and speeds, ") +
                   "a quarter of the reference's paths; flags that you give stay");
}

void addScenesOption(CLI::App& app, std::vector<std::string>& scenes) {
  app.add_option("scenes", scenes,
                 "scenes by name, or by the path of a file or folder; the table holds the name alone, or "
                 "that of the folder. Default: all that can be opened here");
}

void addMethodOptions(CLI::App& app, std::vector<std::string>& methods, std::vector<int>& spp) {
  app.add_option("--methods", methods,
                 "methods, with settings where they differ from the defaults: svgf:as_falcor=1")
      ->delimiter(',')
      ->check(readBy([](const std::string& text) { parseMethod(text); }))
      ->capture_default_str();
  app.add_option("--spp", spp, "paths per pixel and frame")
      ->delimiter(',')
      ->check(NumberIn(ranges::kSpp.min, ranges::kSpp.max))
      ->capture_default_str();
}

bool isFree(const BenchOptions& o, const char* flag) {
  return !o.parsed || o.parsed->count(flag) == 0;
}

void resolve(BenchOptions& o) {
  const Size size = parseSize(o.size);
  const FrameRange range = parseFrameRange(o.frames);
  o.setup.width = size.width, o.setup.height = size.height;
  o.setup.first = range.first, o.setup.last = range.last;
  if (!o.quick) return;
  if (isFree(o, "--size")) {
    o.setup.width = std::max(1, size.width / 2), o.setup.height = std::max(1, size.height / 2);
    if (o.camera && isFree(o, "--rate")) o.setup.frame_rate_hz /= 2;
  }
  if (o.camera && isFree(o, "--frames")) o.setup.last = range.firstHalf().last;
  if (isFree(o, "--reference")) o.setup.reference_spp = std::max(64, o.setup.reference_spp / 4);
}

}  // namespace saccade::eval
