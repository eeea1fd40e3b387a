// `saccade-eval figure N` makes a figure of the paper on our scenes, and `figure all` makes all of them.
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "base/new_folder.h"
#include "base/number_in.h"
#include "eval/bench/arguments.h"
#include "eval/bench/interrupt.h"
#include "eval/bench/open_scene.h"
#include "eval/commands/commands.h"
#include "eval/figures/figure_page.h"
#include "saccade/wire/ranges.h"

namespace saccade::eval {
namespace {

constexpr int kQuickPaths = 128;  // at most, with --quick
const std::vector<double> kQuickSpeeds{0.1, 0.67, 4};

// Adds the flags of every figure.
void addCommonOptions(CLI::App& app, FigureOptions& o) {
  app.add_option("scenes", o.scenes, "scenes by name, or by the path of a file or folder")
      ->capture_default_str();
  addBenchOptions(app, o.bench);
  app.add_option("-o,--output", o.output, "folder for the table and the pictures")
      ->check(CLI::Validator(newFolderFault, ""))
      ->capture_default_str();
}

void addOptions(CLI::App& app, FigureOptions& o) {
  addCommonOptions(app, o);
  addMethodOptions(app, o.methods, o.spp);
  if (!o.speeds.empty()) {
    app.add_option("--speeds", o.speeds, "pixels per frame")
        ->delimiter(',')
        ->check(NumberIn(1e-3, 1e3))
        ->capture_default_str();
  }
  if (!o.thresholds.empty()) {
    app.add_option("--thresholds", o.thresholds, "C of the events")
        ->delimiter(',')
        ->check(NumberIn(ranges::kThreshold.min, ranges::kThreshold.max))
        ->capture_default_str();
  }
  if (o.pixel) {
    app.add_option("--pixel", *o.pixel, "X,Y; default: a pixel that always shows a smooth surface")
        ->delimiter(',')
        ->expected(2)
        ->check(CLI::NonNegativeNumber);
  }
}

// Reads the texts, and reports their faults before anything is rendered.
void resolve(FigureOptions& o) {
  resolve(o.bench);
  if (o.bench.quick && !o.speeds.empty() && isFree(o.bench, "--speeds")) o.speeds = kQuickSpeeds;
  if (o.bench.quick && isFree(o.bench, "--spp"))
    std::erase_if(o.spp, [](int spp) { return spp > kQuickPaths; });
  if (o.scenes.empty()) o.scenes = availableScenes();
  requireTableNames(o.scenes);
  checkSpp(o.methods, o.spp);
}

// Writes the page anew after each figure.
void runFigures(const std::vector<FigureRun>& runs, const std::string& folder) {
  std::filesystem::create_directories(folder);
  TilePool pool(hardwareThreads());
  watchInterrupt();
  try {
    for (const auto& [figure, options] : runs) {
      std::printf("figure %d: %s\n", options.number, figure->what);
      std::fflush(stdout);
      figure->run(options, pool);
      writeFigurePage(runs, folder);
    }
  } catch (const Interrupted&) {
    throw std::runtime_error("interrupted; the same command continues where it stopped");
  }
}

void addFigure(CLI::App& parent, const Figure& figure) {
  auto o = std::make_shared<FigureOptions>(figure.defaults);
  o->output = "out/figure" + std::to_string(o->number);
  auto* c = parent.add_subcommand(std::to_string(o->number), figure.what);
  addOptions(*c, *o);
  c->callback([o, &figure] {
    resolve(*o);
    runFigures({{&figure, *o}}, o->output);
  });
}

// The figure with those of the given flags that it has.
FigureRun withFlags(const Figure& figure, const CLI::App& given, const std::string& folder) {
  FigureRun run{&figure, figure.defaults};
  CLI::App app;
  addOptions(app, run.options);
  for (const CLI::Option* option : given.get_options()) {
    CLI::Option* same = app.get_option_no_throw(option->get_name());
    if (option->empty() || !same) continue;
    same->add_result(option->results());
    same->run_callback();
  }
  resolve(run.options);
  run.options.output = folder, run.options.bench.parsed = nullptr;
  return run;
}

void addAllFigures(CLI::App& parent) {
  auto o = std::make_shared<FigureOptions>();
  o->output = "out/figures";
  auto* c =
      parent.add_subcommand("all", "make all figures, with one page; flags count for each that has them");
  addCommonOptions(*c, *o);
  for (CLI::Option* option : c->get_options()) {
    const bool own = option->check_name("--output") || option->check_name("--cache");
    if (!own && option->get_expected_min() > 0) option->default_str("varies");
  }
  c->callback([o, c] {
    std::vector<FigureRun> runs;
    for (const Figure& figure : figureTable()) runs.push_back(withFlags(figure, *c, o->output));
    runFigures(runs, o->output);
  });
}

}  // namespace

void addFigureCommand(CLI::App& app) {
  auto* c = app.add_subcommand("figure",
                               "make a figure of the paper on our scenes: a table, pictures and index.html");
  for (const Figure& figure : figureTable()) addFigure(*c, figure);
  addAllFigures(*c);
  requireSubcommand(*c, "figure");
}

}  // namespace saccade::eval
