// `saccade-eval odds` compares the odds that events are artefacts with the share that is.
#include <cstdio>
#include <filesystem>
#include <memory>

#include "base/new_folder.h"
#include "eval/bench/arguments.h"
#include "eval/bench/bench_options.h"
#include "eval/bench/interrupt.h"
#include "eval/bench/open_scene.h"
#include "eval/commands/commands.h"
#include "eval/figures/odds_bins.h"
#include "eval/pictures/svg_chart.h"
#include "eval/pictures/text.h"

namespace saccade::eval {
namespace {

struct OddsOptions {
  BenchOptions bench;
  std::vector<std::string> scenes{"cornell-box", "textured-cornell-box", "cornell-bunny"};
  std::vector<std::string> methods{"event_svgf"};
  std::vector<int> spp{2, 8};
  std::string output = "out/odds";
};

struct OddsRow {
  std::string scene, method;
  int spp;
  OddsBins odds;
};

void measureScene(const OddsOptions& o, const std::string& scene, TilePool& pool,
                  std::vector<OddsRow>& rows) {
  BenchSetup setup = o.bench.setup;
  setup.scene = scene;
  const Bench bench(setup, pool);
  std::printf("%s: %.2f px per frame, error of the reference's dI %.3f\n", sceneName(scene).c_str(),
              bench.medianPxPerFrame(), bench.referenceError());
  const ChangeSequence truth = sequenceOf(bench.truth());
  forEachRun(bench, o.methods, o.spp, [&](const std::string& method, int spp, const ChangeSequence& run) {
    rows.push_back({sceneName(scene), method, spp, binsOfOdds(run, truth, o.bench.bias, o.bench.threshold)});
  });
}

void printRows(const std::vector<OddsRow>& rows) {
  std::printf("\n%-22s %-18s %4s %8s %9s %12s %6s\n", "scene", "method", "spp", "events", "mean odds",
              "false share", "error");
  for (const auto& [scene, method, spp, odds] : rows) {
    const OddsBin all = odds.mean();
    std::printf("%-22s %-18s %4d %8.0f %9.3f %12.3f %6.3f\n", scene.c_str(), method.c_str(), spp, all.events,
                all.odds, all.false_share, odds.error());
  }
}

std::string csvOf(const std::vector<OddsRow>& rows) {
  std::string csv = "scene,method,spp,events,odds,false_share\n";
  for (const auto& [scene, method, spp, odds] : rows) {
    for (const OddsBin& bin : odds.bins)
      csv += format("%s,%s,%d,%.0f,%g,%g\n", scene.c_str(), method.c_str(), spp, bin.events, bin.odds,
                    bin.false_share);
  }
  return csv;
}

// A panel for each scene.
std::string chartOf(const std::vector<OddsRow>& rows) {
  std::vector<ChartPanel> panels;
  for (const auto& [scene, method, spp, odds] : rows) {
    if (panels.empty() || panels.back().title != scene) {
      ChartPanel& panel = panels.emplace_back(
          ChartPanel{scene, "mean odds of a bin", "share of its events that is false", {}});
      panel.x_scale = panel.y_scale = Scale::kLinear;
      panel.lines.push_back({"equal", {{0, 0, ""}, {1, 1, ""}}, LineStyle::kReference});
    }
    ChartLine& line =
        panels.back().lines.emplace_back(ChartLine{format("%s, %d spp", method.c_str(), spp), {}});
    for (const OddsBin& bin : odds.bins)
      if (bin.events > 0) line.points.push_back({bin.odds, bin.false_share, format("%.0f", bin.events)});
  }
  return drawCharts(panels, 3);
}

void runOdds(OddsOptions& o) {
  resolve(o.bench);
  requireTableNames(o.scenes);
  checkSpp(o.methods, o.spp);
  const std::filesystem::path folder(o.output);
  std::filesystem::create_directories(folder);
  TilePool pool(hardwareThreads());
  watchInterrupt();
  std::vector<OddsRow> rows;
  try {
    for (const std::string& scene : o.scenes) measureScene(o, scene, pool, rows);
  } catch (const Interrupted&) {
    throw std::runtime_error("interrupted; the same command keeps the reference frames so far");
  }
  printRows(rows);
  writeText((folder / "odds.csv").string(), "# " + o.bench.text() + '\n' + csvOf(rows));
  writeText((folder / "odds.svg").string(), chartOf(rows));
  std::printf("wrote %s/odds.csv and odds.svg\n", o.output.c_str());
}

}  // namespace

void addOddsCommand(CLI::App& app) {
  auto o = std::make_shared<OddsOptions>();
  o->bench.size = "64x64", o->bench.frames = "10:21", o->bench.threshold = 0.1, o->bench.repeats = 0;
  auto* c = app.add_subcommand(
      "odds", "compare the odds that events are artefacts with the share that is: a table and a picture");
  c->add_option("scenes", o->scenes, "scenes by name, or by the path of a file or folder")
      ->capture_default_str();
  addMethodOptions(*c, o->methods, o->spp);
  addBenchOptions(*c, o->bench);
  c->add_option("-o,--output", o->output, "folder for the table and the picture")
      ->check(CLI::Validator(newFolderFault, ""))
      ->capture_default_str();
  c->callback([o] { runOdds(*o); });
}

}  // namespace saccade::eval
