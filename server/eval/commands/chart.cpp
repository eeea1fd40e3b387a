// `saccade-eval chart` measures accuracy against CPU time for every method at several spp, and draws it.
#include <cstdio>
#include <filesystem>
#include <memory>

#include "base/default_cache.h"
#include "base/new_folder.h"
#include "base/number_in.h"
#include "eval/bench/bench_options.h"
#include "eval/bench/interrupt.h"
#include "eval/bench/open_scene.h"
#include "eval/bench/results.h"
#include "eval/bench/within.h"
#include "eval/commands/commands.h"
#include "eval/figures/accuracy_chart.h"
#include "eval/figures/change_pictures.h"
#include "eval/figures/equal_time_rows.h"
#include "eval/pictures/page.h"
#include "eval/pictures/text.h"

namespace saccade::eval {
namespace {

struct ChartOptions : AccuracyChart {
  BenchOptions bench;
  std::vector<std::string> within;
  std::vector<double> budgets;
  std::string output = defaultCache() + "/chart";
  int pictures_spp = 2;
};

// "svgf:as_falcor=1: SVGF: ...; as_falcor: 1: with the known faults ..."
std::string describe(const std::string& text) {
  const MethodSpec spec = parseMethod(text);
  const MethodInfo& info = *findMethod(spec.name);
  std::string description = text + ": " + info.description;
  for (const ParamSpec& param : info.params)
    if (spec.params.at(param.name) != param.fallback) description += "; " + param.name + ": " + param.what;
  return description;
}

// Measures the missing rows of one scene, and adds pictures of all methods at one spp to the page. Returns
// the rows of equal time, of --budgets.
std::vector<EqualTimeRow> runScene(const ChartOptions& o, const std::string& scene, TilePool& pool,
                                   ResultTable& table, Page& page) {
  BenchSetup setup = o.bench.setup;
  setup.scene = scene;
  const Bench bench(setup, pool);
  const TimeBench times(setup, bench.scene(), pool);
  const IntensityChange& truth = bench.truth().back().change;
  ChangePictures pictures(truth, static_cast<float>(o.bench.bias), o.bench.threshold);
  Progress progress(scene, static_cast<double>(o.methods.size() * o.spp.size()));
  for (const std::string& text : o.methods) {
    const MethodSpec method = parseMethod(text);
    for (const int spp : o.spp) {
      progress.add(1);
      if (!method.takes(spp)) continue;
      const Result result = measure(bench, sceneName(scene), method, spp, o.bench, table, &times);
      if (spp != o.pictures_spp) continue;
      pictures.addMethod(text + ", " + std::to_string(spp) + " spp", bench.run(method, spp, 1).changes.back(),
                         result.score);
    }
  }
  pictures.addReference("reference", truth, bench.referenceError());
  page.heading(format("%s: %.2f px per frame", sceneName(scene).c_str(), bench.medianPxPerFrame()));
  page.svg(pictures.draw());
  if (o.budgets.empty()) return {};
  return measureEqualTimes(bench, sceneName(scene), o.methods, o.budgets, o.bench, table, times);
}

bool isComplete(const ChartOptions& o, const ResultTable& table) {
  for (const std::string& scene : o.scenes) {
    for (const std::string& method : o.methods) {
      for (const int spp : o.spp) {
        if (parseMethod(method).takes(spp) && !table.find(sceneName(scene), method, spp)) return false;
      }
    }
  }
  return true;
}

// Fills the table, and draws it.
void renderChart(const ChartOptions& o, ResultTable& table) {
  TilePool pool(hardwareThreads());
  Page page("Saccade: accuracy against time");
  page.paragraph("Settings: " + o.bench.text() + ". CPU time is the sum over all threads.");
  for (const std::string& method : o.methods) page.paragraph(describe(method));
  std::vector<EqualTimeRow> equal;
  watchInterrupt();
  try {
    for (const std::string& scene : o.scenes)
      for (EqualTimeRow& row : runScene(o, scene, pool, table, page)) equal.push_back(std::move(row));
  } catch (const Interrupted&) {
    throw std::runtime_error("interrupted; the same command continues where it stopped");
  }
  if (!equal.empty())
    writeEqualTimes(equal, o.bench.text(), (std::filesystem::path(o.output) / "budgets.csv").string());
  const std::string chart = drawAccuracyChart(o, table);
  page.heading("Accuracy against time");
  page.svg(chart);
  const std::filesystem::path folder(o.output);
  writeText((folder / "chart.svg").string(), chart);
  page.write((folder / "index.html").string());
  std::printf("wrote %s, chart.svg and index.html\n", table.path().c_str());
}

void runChart(ChartOptions& o) {
  resolve(o.bench);
  // Faults of the flags are reported before anything is rendered.
  for (const std::string& method : o.methods) parseMethod(method);
  for (const std::string& metric : o.metrics) findMetric(metric);
  std::vector<Within> limits;
  for (const std::string& limit : o.within) limits.push_back(parseWithin(limit));
  if (o.scenes.empty()) o.scenes = availableScenes();
  requireTableNames(o.scenes);

  ResultTable table((std::filesystem::path(o.output) / "results.csv").string(), o.bench.text());
  if (limits.empty() || !o.budgets.empty() || !isComplete(o, table)) renderChart(o, table);
  for (const Within& limit : limits)
    std::fputs(answerWithin(readAccuracyTable(table.path()), limit).c_str(), stdout);
}

}  // namespace

void addChartCommand(CLI::App& app) {
  auto o = std::make_shared<ChartOptions>();
  auto* c = app.add_subcommand(
      "chart",
      "measure accuracy against CPU time for every method; after an interruption the same command continues");
  addScenesOption(*c, o->scenes);
  addMethodOptions(*c, o->methods, o->spp);
  c->add_option("--metrics", o->metrics, "columns of results.csv to draw")
      ->delimiter(',')
      ->capture_default_str();
  c->add_option("--within", o->within,
                "20ms: print the most accurate setting in that CPU time; 2%: print the fastest setting with "
                "at most 0.02 "
                "false events per pixel and frame. A complete table is not measured again")
      ->check(readBy(parseWithin));
  c->add_option("--budgets", o->budgets,
                "compare at equal CPU time: 4 takes as many paths as fit 4 times the time of the default "
                "method at two paths")
      ->delimiter(',')
      ->check(NumberIn(1e-3, 1e3));
  addBenchOptions(*c, o->bench);
  c->add_option("-o,--output", o->output, "folder for results.csv, chart.svg, index.html, and budgets.csv")
      ->check(CLI::Validator(newFolderFault, ""))
      ->capture_default_str();
  c->callback([o] { runChart(*o); });
}

}  // namespace saccade::eval
