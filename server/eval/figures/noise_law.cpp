// Figure 5: false events against the noise of dL, for every method, spp and threshold.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "eval/bench/open_scene.h"
#include "eval/figures/false_event_rows.h"
#include "eval/figures/figure.h"
#include "eval/figures/regression.h"
#include "eval/pictures/svg_chart.h"
#include "eval/pictures/text.h"

namespace saccade::eval {
namespace {

using Row = FalseEventRow;

// A law of Appendix B for a row: y = theory x.
struct Law {
  const char *title, *x_label, *y_label;
  double theory;
  double (*x)(const Row&), (*y)(const Row&);
};

constexpr const char *kMeanNoise = "mean |noise of dL| / C", *kSigma = "sigma of dL / C",
                     *kFalse = "events per pixel-frame", *kBoth = "false + missed per pixel-frame";
const double kGaussian = std::sqrt(2 / std::numbers::pi);  // [E (33)]
const Law kLaws[] = {
    {"pixels at rest, random threshold phase", kMeanNoise, kFalse, 1,
     [](const Row& r) { return r.counted.quiet.noise.mean_abs / r.C; },
     [](const Row& r) { return r.counted.quiet.fresh_phase; }},
    {"pixels at rest, random threshold phase", kSigma, kFalse, kGaussian,
     [](const Row& r) { return r.counted.quiet.noise.sigma / r.C; },
     [](const Row& r) { return r.counted.quiet.fresh_phase; }},
    {"pixels at rest, without outliers", kSigma, kFalse, kGaussian,
     [](const Row& r) { return r.counted.quiet.noise.sigma_trimmed / r.C; },
     [](const Row& r) { return r.counted.quiet.fresh_phase; }},
    {"pixels at rest, accumulating sensor", kMeanNoise, kFalse, 1,
     [](const Row& r) { return r.counted.quiet.noise.mean_abs / r.C; },
     [](const Row& r) { return r.counted.quiet.accumulating; }},
    {"all pixels", kMeanNoise, kBoth, 1, [](const Row& r) { return r.counted.all.noise.mean_abs / r.C; },
     [](const Row& r) { return r.counted.all.false_and_missed; }},
    {"changes below C", kMeanNoise, kBoth, 1,
     [](const Row& r) { return r.counted.small.noise.mean_abs / r.C; },
     [](const Row& r) { return r.counted.small.false_and_missed; }},
};

void measureScene(const std::string& scene, const FigureOptions& o, TilePool& pool, std::vector<Row>& rows) {
  BenchSetup setup = o.bench.setup;
  setup.scene = scene;
  const Bench bench(setup, pool);
  std::printf("%s: %.2f px per frame, error of the reference's dI %.3f\n", sceneName(scene).c_str(),
              bench.medianPxPerFrame(), bench.referenceError());
  const ChangeSequence truth = sequenceOf(bench.truth());
  forEachRun(bench, o.methods, o.spp, [&](const std::string& method, int spp, const ChangeSequence& run) {
    for (const double C : o.thresholds)
      rows.push_back({sceneName(scene), method, spp, C, countFalseEvents(run, truth, o.bench.bias, C)});
  });
}

void printLaw(const Law& law, const std::vector<Row>& rows) {
  std::vector<Sample> samples;
  for (const Row& r : rows) {
    if (std::isfinite(law.y(r))) samples.push_back({law.x(r), law.y(r)});
  }
  const Regression line = throughOrigin(samples), power = powerLaw(samples);
  std::printf("%-40s %-24s %7.3f %7.3f %7.4f %9.3f %7.4f\n", law.title, law.x_label, law.theory, line.slope,
              line.r2, power.slope, power.r2);
}

ChartPanel panelOf(const Law& law, const FigureOptions& o, const std::vector<Row>& rows) {
  ChartPanel panel{law.title, law.x_label, law.y_label, {}};
  std::vector<double> xs;
  for (const std::string& method : o.methods) {
    ChartLine line{method, {}, LineStyle::kMarks};
    for (const Row& r : rows) {
      const double x = law.x(r), y = law.y(r);
      if (r.method != method || !(x > 0) || !(y > 0)) continue;
      line.points.push_back({x, y, ""});
      xs.push_back(x);
    }
    panel.lines.push_back(std::move(line));
  }
  if (xs.empty()) return panel;
  const auto [low, high] = std::minmax_element(xs.begin(), xs.end());
  const std::vector<ChartPoint> ends{{*low, law.theory * *low, ""}, {*high, law.theory * *high, ""}};
  panel.lines.insert(panel.lines.begin(), {"theory", ends, LineStyle::kReference});
  return panel;
}

}  // namespace

void runNoiseLaw(const FigureOptions& o, TilePool& pool) {
  std::vector<Row> rows;
  for (const std::string& scene : o.scenes) measureScene(scene, o, pool, rows);
  printRows(rows);
  writeText(o.path(".csv"), "# " + o.bench.text() + '\n' + csvOf(rows));
  std::printf("\n%-40s %-24s %7s %7s %7s %9s %7s\n", "law", "x", "theory", "slope", "r2", "exponent", "r2");
  std::vector<ChartPanel> panels;
  for (const Law& law : kLaws) {
    printLaw(law, rows);
    panels.push_back(panelOf(law, o, rows));
  }
  writePicture(o, ".svg", drawCharts(panels, 3));
}

}  // namespace saccade::eval
