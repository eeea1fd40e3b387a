// `saccade-eval figure N` makes a figure of the paper on our scenes.
#include <filesystem>
#include <memory>
#include <set>
#include <stdexcept>

#include "base/new_folder.h"
#include "base/number_in.h"
#include "eval/bench/arguments.h"
#include "eval/bench/interrupt.h"
#include "eval/bench/open_scene.h"
#include "eval/commands/commands.h"
#include "eval/figures/figure.h"
#include "eval/pictures/page.h"
#include "saccade/wire/ranges.h"

namespace saccade::eval {
namespace {

// A page with all pictures of the figure that the folder holds.
void writePage(const Figure& figure, const FigureOptions& o) {
  const std::string prefix = "figure" + std::to_string(o.number);
  std::set<std::string> pictures;
  for (const auto& entry : std::filesystem::directory_iterator(o.output)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(prefix) && name.ends_with(".svg")) pictures.insert(name);
  }
  Page page("Saccade: " + prefix + ", " + figure.what);
  page.paragraph(o.bench.text());
  for (const std::string& name : pictures) page.picture(name);
  page.write((std::filesystem::path(o.output) / "index.html").string());
}

void runFigure(const Figure& figure, FigureOptions& o) {
  resolve(o.bench);
  if (o.scenes.empty()) o.scenes = availableScenes();
  requireTableNames(o.scenes);
  checkSpp(o.methods, o.spp);
  std::filesystem::create_directories(o.output);
  TilePool pool(hardwareThreads());
  watchInterrupt();
  try {
    figure.run(o, pool);
    writePage(figure, o);
  } catch (const Interrupted&) {
    throw std::runtime_error("interrupted; the same command continues where it stopped");
  }
}

void addFigure(CLI::App& parent, const Figure& figure) {
  auto o = std::make_shared<FigureOptions>(figure.defaults);
  const std::string number = std::to_string(o->number);
  o->output = "out/figure" + number;
  auto* c = parent.add_subcommand(number, figure.what);
  c->add_option("scenes", o->scenes, "scenes by name, or by the path of a file or folder")
      ->capture_default_str();
  addMethodOptions(*c, o->methods, o->spp);
  if (!o->speeds.empty()) {
    c->add_option("--speeds", o->speeds, "pixels per frame")
        ->delimiter(',')
        ->check(NumberIn(1e-3, 1e3))
        ->capture_default_str();
  }
  if (!o->thresholds.empty()) {
    c->add_option("--thresholds", o->thresholds, "C of the events")
        ->delimiter(',')
        ->check(NumberIn(ranges::kThreshold.min, ranges::kThreshold.max))
        ->capture_default_str();
  }
  if (o->pixel) {
    c->add_option("--pixel", *o->pixel, "X,Y; default: a pixel that always shows a smooth surface")
        ->delimiter(',')
        ->expected(2)
        ->check(CLI::NonNegativeNumber);
  }
  addBenchOptions(*c, o->bench);
  c->add_option("-o,--output", o->output, "folder for the table and the pictures")
      ->check(CLI::Validator(newFolderFault, ""))
      ->capture_default_str();
  c->callback([o, &figure] { runFigure(figure, *o); });
}

}  // namespace

void addFigureCommand(CLI::App& app) {
  auto* c = app.add_subcommand("figure",
                               "make a figure of the paper on our scenes: a table, pictures and index.html");
  for (const Figure& figure : figureTable()) addFigure(*c, figure);
  requireSubcommand(*c, "figure");
}

}  // namespace saccade::eval
