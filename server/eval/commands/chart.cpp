// `saccade-eval chart`: accuracy against CPU time for every method at several budgets, and pictures of each.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "base/default_cache.h"
#include "eval/bench/bench_options.h"
#include "eval/bench/interrupt.h"
#include "eval/bench/open_scene.h"
#include "eval/bench/results.h"
#include "eval/bench/within.h"
#include "eval/commands/commands.h"
#include "eval/figures/change_pictures.h"
#include "eval/pictures/format.h"
#include "eval/pictures/page.h"
#include "eval/pictures/svg_chart.h"
#include "eval/pictures/write_text.h"
#include "wire/ranges.h"

namespace saccade::eval {
namespace {

struct ChartOptions {
  BenchOptions bench;
  std::vector<std::string> scenes;
  std::vector<std::string> methods{"event_svgf", "svgf", "svgf:as_falcor=1", "pt-correlated", "pt"};
  std::vector<int> spp{1, 2, 4, 8, 32, 128};
  std::vector<std::string> metrics{"dI_l1",         "dL_l1",    "false_events",
                                   "missed_events", "sigma_dL", "voxel_error"};
  std::vector<std::string> within;
  std::string output = defaultCache() + "/chart";
  int pictures_spp = 2;
};

// Runs what is missing of one scene; a section of the page shows the methods at one budget.
void runScene(const ChartOptions& o, const std::string& scene, TilePool& pool, ResultTable& table,
              Page& page) {
  BenchSetup setup = o.bench.setup;
  setup.scene = scene;
  const Bench bench(setup, pool);
  const IntensityChange& truth = bench.truth().back().change;
  ChangePictures pictures(truth, static_cast<float>(o.bench.bias), o.bench.threshold);
  Progress progress(scene, static_cast<double>(o.methods.size() * o.spp.size()));
  for (const std::string& text : o.methods) {
    const MethodSpec method = parseMethod(text);
    for (const int spp : o.spp) {
      progress.add(1);
      if (!method.takes(spp)) continue;
      const Result& result = measure(bench, scene, method, spp, o.bench, table);
      if (spp != o.pictures_spp) continue;
      pictures.add(text + ", " + std::to_string(spp) + " spp", bench.run(method, spp, 1).changes.back(),
                   &result.score);
    }
  }
  pictures.add("reference", truth, nullptr);
  page.heading(format("%s: %.2f px per frame, error of the reference's dI %.3f", scene.c_str(),
                      bench.medianPxPerFrame(), bench.referenceError()));
  page.svg(pictures.draw());
}

const ScoreColumn& findColumn(const std::string& name) {
  for (const ScoreColumn& column : kScoreColumns) {
    if (name == column.name) return column;
  }
  throw CLI::ValidationError("--metrics", "there is no \"" + name + "\"; there are: " + scoreNames());
}

ChartPanel makePanel(const ChartOptions& o, const ResultTable& table, const std::string& scene,
                     const ScoreColumn& metric) {
  ChartPanel panel{scene, "CPU ms per frame", metric.label, {}, true};
  for (const std::string& method : o.methods) {
    ChartLine line{method, {}};
    for (const int spp : o.spp) {
      const Result* r = table.find(scene, method, spp);
      // A logarithmic axis has no place for 0, nor for the infinite error where the truth is 0.
      if (!r || !(r->score.*metric.value > 0) || std::isinf(r->score.*metric.value)) continue;
      line.points.push_back({r->cpu_ms, r->score.*metric.value, std::to_string(spp) + " spp"});
    }
    panel.lines.push_back(std::move(line));
  }
  return panel;
}

std::string drawChart(const ChartOptions& o, const ResultTable& table) {
  std::vector<ChartPanel> panels;
  for (const std::string& scene : o.scenes) {
    for (const std::string& metric : o.metrics)
      panels.push_back(makePanel(o, table, scene, findColumn(metric)));
  }
  return drawCharts(panels, static_cast<int>(o.metrics.size()));
}

bool isComplete(const ChartOptions& o, const ResultTable& table) {
  for (const std::string& scene : o.scenes) {
    for (const std::string& method : o.methods) {
      for (const int spp : o.spp) {
        if (parseMethod(method).takes(spp) && !table.find(scene, method, spp)) return false;
      }
    }
  }
  return true;
}

// Fills the table, and draws it.
void renderChart(const ChartOptions& o, ResultTable& table) {
  TilePool pool(hardwareThreads());
  Page page("Saccade: accuracy against time");
  page.paragraph(o.bench.text() + ". CPU time is that of all threads together.");
  watchInterrupt();
  try {
    for (const std::string& scene : o.scenes) runScene(o, scene, pool, table, page);
  } catch (const Interrupted&) {
    throw std::runtime_error("interrupted; the same command goes on where it stopped");
  }
  const std::string chart = drawChart(o, table);
  page.heading("Accuracy against time");
  page.svg(chart);
  const std::filesystem::path folder(o.output);
  writeText((folder / "chart.svg").string(), chart);
  page.write((folder / "index.html").string());
  std::printf("wrote %s, chart.svg and index.html\n", table.path().c_str());
}

void runChart(ChartOptions& o) {
  resolve(o.bench);
  // What is wrong with the flags is said before anything is rendered.
  for (const std::string& method : o.methods) parseMethod(method);
  for (const std::string& metric : o.metrics) findColumn(metric);
  std::vector<Within> limits;
  for (const std::string& limit : o.within) limits.push_back(parseWithin(limit));
  if (o.scenes.empty()) o.scenes = availableScenes();

  ResultTable table((std::filesystem::path(o.output) / "results.csv").string(), o.bench.text());
  if (limits.empty() || !isComplete(o, table)) renderChart(o, table);
  for (const Within& limit : limits)
    std::fputs(answerWithin(readAccuracyTable(table.path()), limit).c_str(), stdout);
}

}  // namespace

void addChartCommand(CLI::App& app) {
  auto o = std::make_shared<ChartOptions>();
  auto* c = app.add_subcommand(
      "chart", "accuracy against CPU time for every method; can be interrupted and gone on with");
  c->add_option("scenes", o->scenes,
                "scenes by name or scene.xml by path; default: all that can be opened here");
  c->add_option("--methods", o->methods, "names with settings, such as svgf:as_falcor=1")
      ->delimiter(',')
      ->capture_default_str();
  c->add_option("--spp", o->spp, "budgets, paths per pixel and frame")
      ->delimiter(',')
      ->check(CLI::Range(ranges::kSpp.min, ranges::kSpp.max))
      ->capture_default_str();
  c->add_option("--metrics", o->metrics, "columns of results.csv to draw")
      ->delimiter(',')
      ->capture_default_str();
  c->add_option(
      "--within", o->within,
      "20ms: the most accurate setting in that CPU time; 2%: the fastest with at most that many false "
      "events per pixel-frame. A table that stands is not rendered again");
  addBenchOptions(*c, o->bench);
  c->add_option("-o,--output", o->output, "folder for results.csv, chart.svg and index.html")
      ->capture_default_str();
  c->callback([o] { runChart(*o); });
}

}  // namespace saccade::eval
