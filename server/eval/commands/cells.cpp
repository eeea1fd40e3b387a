// `saccade-eval cells` compares methods with baselines over scenes, motions and speeds.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "base/default_cache.h"
#include "base/new_folder.h"
#include "base/number_in.h"
#include "eval/bench/cell_bench.h"
#include "eval/bench/interrupt.h"
#include "eval/bench/open_scene.h"
#include "eval/commands/commands.h"
#include "eval/figures/cell_rows.h"
#include "eval/pictures/text.h"

namespace saccade::eval {
namespace {

struct CellsOptions {
  BenchOptions bench;
  CellGrid grid;
  std::vector<std::string> frames{"17:21"};
  std::vector<std::string> baselines{"event_svgf@2", "svgf@2"};
  std::vector<std::string> candidates{"irradiance_cache@2"};
  std::string output = "out/cells";

  std::string path(const char* file) const { return (std::filesystem::path(output) / file).string(); }
};

std::vector<Setting> settingsOf(const std::string& flag, const std::vector<std::string>& texts) {
  std::vector<Setting> settings;
  for (const std::string& text : texts) settings.push_back(parseSetting(flag, text));
  return settings;
}

// Prints each cell, and writes all so far.
std::vector<ComparedCell> compareAll(const CellsOptions& o, CellBench& bench) {
  const std::vector<Cell> cells = o.grid.cells();
  const auto missing =
      std::count_if(cells.begin(), cells.end(), [&](const Cell& cell) { return !bench.isComplete(cell); });
  Progress progress("cells", static_cast<double>(missing));
  std::vector<ComparedCell> compared;
  for (const Cell& cell : cells) {
    const bool is_new = !bench.isComplete(cell);
    compared.push_back(bench.compare(cell));
    writeText(o.path("ratios.csv"), csvOf(compared));
    progress.clear();
    std::fputs(textOf(compared.back()).c_str(), stdout);
    std::fflush(stdout);
    if (is_new) progress.add(1);
  }
  return compared;
}

void tellFiles(const CellsOptions& o, const std::vector<ComparedCell>& cells) {
  const bool none =
      std::ranges::all_of(cells, [](const ComparedCell& cell) { return !cell.left_out.empty(); });
  const std::string text =
      none ? o.path("ratios.csv") + ", which says why each cell is left out; nothing was measured"
           : o.path("results.csv") +
                 " and ratios.csv, which names the baseline of each ratio and why some are in brackets";
  std::printf("wrote %s\n", text.c_str());
}

void runCells(CellsOptions& o) {
  resolve(o.bench);
  for (const std::string& frames : o.frames) {
    const FrameRange range = parseFrameRange(frames);
    const bool is_halved = o.bench.quick && isFree(o.bench, "--frames");
    o.grid.frames.push_back(is_halved ? range.firstHalf() : range);
  }
  if (o.bench.quick && isFree(o.bench, "--speeds")) o.grid.speeds = {0.33, 2};
  if (o.grid.scenes.empty()) o.grid.scenes = availableScenes();
  requireTableNames(o.grid.scenes);
  CellBench bench(o.bench, settingsOf("--baselines", o.baselines), settingsOf("--candidates", o.candidates),
                  o.path("results.csv"));
  watchInterrupt();
  try {
    const std::vector<ComparedCell> cells = compareAll(o, bench);
    std::fputs(summaryText(cells, o.candidates).c_str(), stdout);
    tellFiles(o, cells);
  } catch (const Interrupted&) {
    throw std::runtime_error("interrupted; the same command continues where it stopped");
  }
}

void addSettings(CLI::App& app, const char* flag, std::vector<std::string>& settings, const char* what) {
  app.add_option(flag, settings, what)->delimiter(',')->capture_default_str();
}

}  // namespace

void addCellsCommand(CLI::App& app) {
  auto o = std::make_shared<CellsOptions>();
  o->bench.camera = false;
  auto* c = app.add_subcommand("cells",
                               "compare methods with baselines over scenes, motions and speeds; after an "
                               "interruption the same command continues");
  addScenesOption(*c, o->grid.scenes);
  addSettings(*c, "--candidates", o->candidates,
              "METHOD@SPP: what is compared, at these paths per pixel and frame");
  addSettings(*c, "--baselines", o->baselines, "METHOD@SPP: each figure is compared with the best of these");
  std::vector<std::string> motions = kCellMotions;
  motions.push_back(kStillCamera);
  c->add_option("--motions", o->grid.motions, "motions of the camera; still where objects move")
      ->delimiter(',')
      ->check(CLI::IsMember(motions))
      ->capture_default_str();
  c->add_option("--speeds", o->grid.speeds, "pixels per frame")
      ->delimiter(',')
      ->check(NumberIn(1e-3, 1e3))
      ->capture_default_str();
  c->add_option(
       "--frames", o->frames,
       "A:B, the frames to score, or one frame; several make more cells. Every run starts at 0, and the "
       "phases of events need two frames")
      ->delimiter(',')
      ->capture_default_str();
  addBenchOptions(*c, o->bench);
  c->add_option("-o,--output", o->output, "folder for results.csv and ratios.csv")
      ->check(CLI::Validator(newFolderFault, ""))
      ->capture_default_str();
  c->callback([o] { runCells(*o); });
}

}  // namespace saccade::eval
