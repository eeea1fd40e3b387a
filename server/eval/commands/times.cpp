// `saccade-eval times` compares the events of streams with those of one that is fine in time.
#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/default_cache.h"
#include "base/new_folder.h"
#include "base/number_in.h"
#include "eval/bench/arguments.h"
#include "eval/bench/feed_options.h"
#include "eval/bench/interrupt.h"
#include "eval/bench/kept_bake.h"
#include "eval/bench/open_scene.h"
#include "eval/bench/time_truth.h"
#include "eval/commands/commands.h"
#include "eval/figures/time_chart.h"
#include "eval/pictures/text.h"
#include "feed/refinement.h"
#include "methods/method_spec.h"
#include "saccade/wire/ranges.h"

namespace saccade::eval {
namespace {

struct TimesOptions : FeedOptions {
  std::vector<double> frames{1, 2, 4}, intervals{1, 0.5}, refined{1};
  SensorConfig sensor{.reconstruction = "direct"};
  int windows = 4, fine = 64;
  double bake_error = 0;
  std::string cache = defaultCache();
  std::string output;  // of a chart
};

std::string label(const char* text, double value) {
  char number[32];
  std::snprintf(number, sizeof number, text, value);
  return number;
}

// A number without a meaning is a dash.
std::string figure(double value) {
  return std::isfinite(value) ? label("%.4f", value) : "-";
}

void printRow(const std::string& name, const TimeTruthRow& row, const TimeTruthRow& reference) {
  std::printf("%-24s %9.1f %9.2f %8.3f %9.0f %8s %8s %8s\n", name.c_str(), row.intervals, row.cpu_ms,
              row.cpu_ms / reference.cpu_ms, row.events, figure(row.errors.false_share).c_str(),
              figure(row.errors.missed_share).c_str(), figure(row.errors.time).c_str());
  std::fflush(stdout);
}

// A row for each of `values`, printed as it comes.
template <class Measure>
TimeSeries measureAll(const char* name, const char* text, const std::vector<double>& values,
                      const TimeTruthRow& reference, Measure&& measure) {
  TimeSeries series{name, {}};
  for (const double value : values) {
    series.rows.emplace_back(label(text, value), measure(value));
    printRow(series.rows.back().first, series.rows.back().second, reference);
  }
  return series;
}

void measure(const TimesOptions& o, const TimeTruthSetup& setup, TilePool& pool) {
  TimeTruth truth(setup, pool);
  std::printf("%-24s %9s %9s %8s %9s %8s %8s %8s\n", "per window", "intervals", "CPU ms", "of ref.", "events",
              "false", "missed", "time");
  printRow(label("reference, %g frames", o.fine), truth.reference(), truth.reference());
  const auto all = [&](const char* name, const char* text, const std::vector<double>& values,
                       auto&& measure) { return measureAll(name, text, values, truth.reference(), measure); };
  std::vector<TimeSeries> series{
      all("whole frames", "%g frames", o.frames, [&](double frames) { return truth.measureFrames(frames); }),
      all("intervals that follow motion", "intervals of %g px", o.intervals,
          [&](double px) { return truth.measureIntervals({.px = px}, false); })};
  if (refinementFault(setup.feed).empty())
    series.push_back(all("refined intervals", "refined ones of %g px", o.refined,
                         [&](double px) { return truth.measureIntervals({.px = px}, true); }));
  if (o.output.empty()) return;
  writeText(o.output, drawTimeChart(sceneName(o.scene) + ", " + o.trajectory, series));
  std::printf("wrote %s\n", o.output.c_str());
}

void runTimes(TimesOptions& o) {
  if (!o.output.empty()) checkOutputFile(o.output, {".svg"});
  o.feed.params = parseMethod(o.feed.method).params;
  auto [scene, path] = open(o);
  TilePool pool(o.threads);
  watchInterrupt();
  try {
    if (o.bake_error > 0)
      o.feed.baked =
          keptLight(scene, path, o.feed, o.windows, o.bake_error, o.cache, sceneName(o.scene), pool);
    measure(o, {scene, path, o.feed, o.sensor, o.windows, o.fine}, pool);
  } catch (const Interrupted&) {
    throw std::runtime_error("interrupted");
  }
}

}  // namespace

void addTimesCommand(CLI::App& app) {
  auto o = std::make_shared<TimesOptions>();
  o->trajectory = "truck:1px", o->feed.frame_rate_hz = 100;
  auto* c =
      app.add_subcommand("times",
                         "compare the events of streams with those of one that is fine in time; a window "
                         "is a frame at --rate, best with 1 px of motion");
  addFeedOptions(*c, *o);
  c->add_option("--method", o->feed.method, "one of: " + methodNames())->capture_default_str();
  c->add_option("--windows", o->windows, "how many windows")
      ->check(NumberIn(1, 10'000))
      ->capture_default_str();
  c->add_option("--fine", o->fine, "frames of the reference per window")
      ->check(NumberIn(1, 4096))
      ->capture_default_str();
  c->add_option("--frames", o->frames, "streams with so many frames per window")
      ->check(NumberIn(1.0 / 64, 4096.0))
      ->capture_default_str();
  c->add_option("--intervals", o->intervals, "streams whose intervals follow motion, px")
      ->check(NumberIn(ranges::kIntervalPx.min, ranges::kIntervalPx.max))
      ->capture_default_str();
  c->add_option("--refined", o->refined, "the same, with pixels refined to a sixteenth, if the method can")
      ->check(NumberIn(ranges::kIntervalPx.min, ranges::kIntervalPx.max))
      ->capture_default_str();
  c->add_option("--threshold", o->sensor.threshold, "C of ON and OFF events")
      ->check(NumberIn(ranges::kThreshold.min, ranges::kThreshold.max))
      ->capture_default_str();
  c->add_option("--seed", o->feed.seed, "seed of the random numbers")
      ->check(wholeNumber())
      ->capture_default_str();
  addBakeOption(*c, o->bake_error);
  c->add_option("--cache", o->cache, "folder for bakes")
      ->check(CLI::Validator(newFolderFault, ""))
      ->capture_default_str();
  c->add_option("-o,--output", o->output, "SVG picture: a chart of error against CPU time");
  c->callback([o] {
    o->sensor.threshold_off = o->sensor.threshold;
    o->sensor.seed = o->feed.seed;
    runTimes(*o);
  });
}

}  // namespace saccade::eval
