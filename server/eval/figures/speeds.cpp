#include <cmath>

#include "eval/bench/open_scene.h"
#include "eval/bench/results.h"
#include "eval/figures/figure.h"
#include "eval/metrics/brightness_change.h"
#include "eval/pictures/picture_grid.h"
#include "eval/pictures/signed_picture.h"
#include "eval/pictures/svg_chart.h"
#include "eval/pictures/text.h"

namespace saccade::eval {
namespace {

constexpr const char* kMotions[] = {"right", "forward"};
constexpr double Score::*kMetrics[] = {&Score::sigma_dL, &Score::noise_dL,     &Score::bias_dL,
                                       &Score::dL_l1,    &Score::false_events, &Score::missed_events};

// The key of a row: which scene, direction and speed.
std::string rowName(const std::string& scene, const std::string& motion, double speed) {
  return sceneName(scene) + " " + motion + " " + format("%g px", speed);
}

// Runs one speed: a column of the pictures, dL of the truth and of every method.
void runSpeed(const FigureOptions& o, const std::string& scene, const std::string& motion, double speed,
              TilePool& pool, ResultTable& table, std::vector<std::vector<GridPicture>>& rows) {
  BenchSetup setup = o.bench.setup;
  setup.scene = scene, setup.trajectory = motion, setup.px_per_frame = speed;
  const Bench bench(setup, pool);
  const auto bias = static_cast<float>(o.bench.bias);
  const IntensityChange& truth = bench.truth().back().change;
  const float scale = colorScale(brightnessChange(truth, bias));
  rows[0].push_back(signedPicture(
      brightnessChange(truth, bias), scale,
      format("own error %.3f, full colour %.2g", bench.referenceError(), static_cast<double>(scale))));
  const std::string name = rowName(setup.scene, motion, speed);
  for (std::size_t m = 0; m < o.methods.size(); ++m) {
    const MethodSpec method = parseMethod(o.methods[m]);
    const Score score = measure(bench, name, method, o.spp.front(), o.bench, table).score;
    rows[m + 1].push_back(
        signedPicture(brightnessChange(bench.run(method, o.spp.front(), 1).changes.back(), bias), scale,
                      format("L1 %.3f, sigma %.2g", score.dL_l1, score.sigma_dL)));
  }
}

ChartPanel makePanel(const FigureOptions& o, const ResultTable& table, const std::string& scene,
                     const std::string& motion, double Score::*metric) {
  const ScoreColumn& column = columnOf(metric);
  ChartPanel panel{sceneName(scene) + ", " + motion,
                   "pixels per frame",
                   std::string(column.label) + " (lower is better)",
                   {}};
  for (const std::string& method : o.methods) {
    ChartLine line{method, {}};
    for (const double speed : o.speeds) {
      const Result* r = table.find(rowName(scene, motion, speed), method, o.spp.front());
      if (r && r->score.*metric > 0) {
        const double error = r->seed_error.*metric;
        line.points.push_back({speed, r->score.*metric, "", std::isfinite(error) ? error : 0});
      }
    }
    panel.lines.push_back(std::move(line));
  }
  return panel;
}

// Pictures of one scene and motion at all speeds.
void runMotion(const FigureOptions& o, const std::string& scene, const std::string& motion, TilePool& pool,
               ResultTable& table) {
  std::vector<std::string> columns, names{"dL of the reference"};
  names.insert(names.end(), o.methods.begin(), o.methods.end());
  std::vector<std::vector<GridPicture>> rows(names.size());
  Progress progress(sceneName(scene) + " " + motion, static_cast<double>(o.speeds.size()));
  for (const double speed : o.speeds) {
    runSpeed(o, scene, motion, speed, pool, table, rows);
    columns.push_back(format("%g px per frame", speed));
    progress.add(1);
  }
  writePicture(o, "_" + sceneName(scene) + "_" + motion + ".svg",
               drawPictureGrid(columns, names, rows, kChangeKey));
}

}  // namespace

void runSpeeds(const FigureOptions& o, TilePool& pool) {
  ResultTable table(o.path(".csv"), o.bench.text());
  std::vector<ChartPanel> panels;
  for (const std::string& scene : o.scenes) {
    for (const std::string motion : kMotions) {
      runMotion(o, scene, motion, pool, table);
      for (const auto metric : kMetrics) panels.push_back(makePanel(o, table, scene, motion, metric));
    }
  }
  writePicture(o, ".svg", drawCharts(panels, static_cast<int>(std::size(kMetrics))));
  printTable(table);
}

}  // namespace saccade::eval
