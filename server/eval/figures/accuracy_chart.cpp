#include "eval/figures/accuracy_chart.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>

#include "eval/bench/open_scene.h"
#include "eval/pictures/svg_chart.h"
#include "eval/pictures/text.h"

namespace saccade::eval {
namespace {

ChartPanel makePanel(const AccuracyChart& o, const ResultTable& table, const std::string& scene,
                     const ScoreColumn& metric) {
  ChartPanel panel{scene, "CPU ms per frame", format("%s (%s)", metric.label, metric.goal), {}, true};
  ChartLine reference{"own error of the reference", {}, LineStyle::kReference};
  for (const std::string& method : o.methods) {
    ChartLine line{method, {}};
    for (const int spp : o.spp) {
      const Result* r = table.find(scene, method, spp);
      // A logarithmic axis has no place for 0, nor for the infinite error where the truth is 0.
      if (!r || !(r->score.*metric.value > 0) || std::isinf(r->score.*metric.value)) continue;
      const double error = r->seed_error.*metric.value;
      line.points.push_back({r->cpu_ms, r->score.*metric.value, std::to_string(spp) + " spp",
                             std::isfinite(error) ? error : 0});
      if (r->reference_error > 0 && std::isfinite(r->reference_error))
        reference.points.push_back({r->cpu_ms, r->reference_error, ""});
    }
    panel.lines.push_back(std::move(line));
  }
  std::sort(reference.points.begin(), reference.points.end(),
            [](const auto& p, const auto& q) { return p.x < q.x; });
  // The reference's own error is a relative L1 of dI: no other metric can be compared with it.
  if (metric.value == &Score::dI_l1) panel.lines.push_back(std::move(reference));
  return panel;
}

}  // namespace

const ScoreColumn& findMetric(const std::string& name) {
  for (const ScoreColumn& column : kScoreColumns) {
    if (name == column.name) return column;
  }
  throw CLI::ValidationError("--metrics", "there is no \"" + name + "\"; there are: " + scoreNames());
}

std::string drawAccuracyChart(const AccuracyChart& o, const ResultTable& table) {
  std::vector<ChartPanel> panels;
  for (const std::string& scene : o.scenes) {
    for (const std::string& metric : o.metrics)
      panels.push_back(makePanel(o, table, sceneName(scene), findMetric(metric)));
  }
  return drawCharts(panels, static_cast<int>(o.metrics.size()));
}

}  // namespace saccade::eval
