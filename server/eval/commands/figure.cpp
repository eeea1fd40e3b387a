// `saccade-eval figure N`: the figures of the paper on our scenes.
#include <filesystem>
#include <memory>

#include "eval/bench/arguments.h"
#include "eval/bench/interrupt.h"
#include "eval/bench/open_scene.h"
#include "eval/commands/commands.h"
#include "eval/figures/figure.h"
#include "wire/ranges.h"

namespace saccade::eval {
namespace {

void runFigure(const Figure& figure, FigureOptions& o) {
  resolve(o.bench);
  if (o.scenes.empty()) o.scenes = availableScenes();
  for (const std::string& method : o.methods) {
    for (const int spp : o.spp) checkSpp(parseMethod(method), spp);
  }
  std::filesystem::create_directories(o.output);
  TilePool pool(hardwareThreads());
  watchInterrupt();
  try {
    figure.run(o, pool);
  } catch (const Interrupted&) {
    throw std::runtime_error("interrupted; the same command goes on where it stopped");
  }
}

void addFigure(CLI::App& parent, const Figure& figure) {
  auto o = std::make_shared<FigureOptions>(figure.defaults);
  const std::string number = std::to_string(o->number);
  o->output = "out/figure" + number;
  auto* c = parent.add_subcommand(number, figure.what);
  c->add_option("scenes", o->scenes, "scenes by name or scene.xml by path")->capture_default_str();
  c->add_option("--methods", o->methods, "names with settings, such as svgf:as_falcor=1")
      ->delimiter(',')
      ->capture_default_str();
  c->add_option("--spp", o->spp, "budgets, paths per pixel and frame")
      ->delimiter(',')
      ->check(CLI::Range(ranges::kSpp.min, ranges::kSpp.max))
      ->capture_default_str();
  if (!o->speeds.empty()) {
    c->add_option("--speeds", o->speeds, "pixels per frame")
        ->delimiter(',')
        ->check(CLI::Range(1e-3, 1e3))
        ->capture_default_str();
  }
  if (!o->thresholds.empty()) {
    c->add_option("--thresholds", o->thresholds, "C of the events")
        ->delimiter(',')
        ->check(CLI::Range(ranges::kThreshold.min, ranges::kThreshold.max))
        ->capture_default_str();
  }
  if (o->pixel) {
    c->add_option("--pixel", *o->pixel, "X,Y; default: one that always shows a smooth surface")
        ->delimiter(',')
        ->expected(2)
        ->check(CLI::NonNegativeNumber);
  }
  addBenchOptions(*c, o->bench);
  c->add_option("-o,--output", o->output, "folder for the table and the pictures")->capture_default_str();
  c->callback([o, &figure] { runFigure(figure, *o); });
}

}  // namespace

void addFigureCommand(CLI::App& app) {
  auto* c = app.add_subcommand("figure", "a figure of the paper on our scenes: a table and pictures");
  c->require_subcommand(1);
  for (const Figure& figure : figureTable()) addFigure(*c, figure);
}

}  // namespace saccade::eval
