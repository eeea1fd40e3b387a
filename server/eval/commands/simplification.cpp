// `saccade-eval simplification` measures the frame time and the events that each feature of a scene adds, and
// names the cheapest model.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "base/names.h"
#include "base/number_in.h"
#include "eval/bench/arguments.h"
#include "eval/bench/interrupt.h"
#include "eval/bench/model_bench.h"
#include "eval/bench/model_search.h"
#include "eval/bench/open_scene.h"
#include "eval/commands/commands.h"
#include "eval/pictures/text.h"
#include "methods/method.h"
#include "saccade/wire/ranges.h"
#include "scene/scene_stats.h"

namespace saccade::eval {
namespace {

struct SimplificationOptions {
  BenchOptions bench;
  std::vector<std::string> scenes;
  std::string method = defaultMethod(true).name, tolerance = "2%";
  int spp = 2;
  std::string output = defaultSimplificationTable();
};

// "without textures", "2 bounces".
std::string difference(const SceneModel& model, const SceneModel& whole) {
  if (model.disabled_features.empty()) return model.text();
  const std::string text = "without " + joinNames(namesOf(model.disabled_features));
  return model.bounces == whole.bounces ? text : SceneModel{model.bounces, {}}.text() + ", " + text;
}

void printRow(const std::string& name, const MeasuredModel& m, const MeasuredModel& whole) {
  const double saved = whole.cpu_ms - m.cpu_ms;
  std::printf("  %-44s %9.3g %7.1f %% %7.2f %% %7.2f %% %9.3g %9.3g\n", name.c_str(), saved,
              100 * saved / whole.cpu_ms, 100 * m.changed, 100 * m.noise, m.false_events, m.missed_events);
}

void printModels(const std::vector<MeasuredModel>& models, const MeasuredModel& jittered) {
  const MeasuredModel& whole = models.front();
  std::printf("  %-44s %9s %9s %9s %9s %9s %9s\n", "", "saves ms", "of it", "changed", "noise", "false",
              "missed");
  for (std::size_t i = 1; i < models.size(); ++i)
    printRow(difference(models[i].model, whole.model), models[i], whole);
  printRow("with jitter", jittered, whole);
}

void printCheapest(const std::vector<MeasuredModel>& models, const std::string& tolerance) {
  const double most = parseTolerance(tolerance);
  const MeasuredModel& best = cheapest(models, most);
  std::printf("  within %s: %s: %.3g ms, %.2f %% of the events change\n", tolerance.c_str(),
              best.model.text().c_str(), best.cpu_ms, 100 * best.changed);
  const auto drowned = std::count_if(models.begin(), models.end(), [&](const MeasuredModel& m) {
    return m.cpu_ms < best.cpu_ms && m.changed <= most && m.noise > most;
  });
  if (drowned > 0)
    std::printf("  for %d faster models the noise exceeds the tolerance: give more paths with --reference\n",
                static_cast<int>(drowned));
  std::printf("\n");
}

std::vector<MeasuredModel> measureScene(const SimplificationOptions& o, const std::string& scene,
                                        TilePool& pool) {
  BenchOptions bench_options = o.bench;
  bench_options.setup.scene = scene;
  const MethodSpec method = parseMethod(o.method);
  ModelBench bench(bench_options, method, o.spp, pool);
  std::printf("%s: %s\n", sceneName(scene).c_str(), statsOf(bench.description()).text().c_str());
  const SceneModel whole{o.bench.setup.bounces, {}};
  std::vector<MeasuredModel> simpler = bench.measure(simplerByOne(whole, featuresOf(bench.description())));
  const auto models = withCombinations(bench.whole(), simpler,
                                       [&](const SceneModel& m) { return bench.measure({m}).front(); });
  std::printf("  %s: %.3g CPU ms per frame of %s at %d spp, %.4g events per pixel-frame at C = %g\n",
              whole.text().c_str(), models.front().cpu_ms, method.text.c_str(), o.spp, bench.events(),
              o.bench.threshold);
  std::printf("  noise: %.2f %% of the events change with other seeds, at half of the paths\n",
              100 * bench.noise());
  printModels(models, bench.jittered());
  printCheapest(models, o.tolerance);
  return models;
}

// Rows of other scenes stay in the file.
SimplificationTable openTable(const SimplificationOptions& o) {
  const std::string settings = o.bench.text() + " method=" + o.method + " spp=" + std::to_string(o.spp);
  if (!std::filesystem::exists(o.output)) return {settings, {}, {}};
  SimplificationTable table = readSimplificationTable(o.output);
  if (table.settings == settings) return table;
  throw std::runtime_error(o.output + " was made with other settings (" + table.settings +
                           "); choose another file or remove it");
}

void runSimplification(SimplificationOptions& o) {
  resolve(o.bench);
  checkSpp(parseMethod(o.method), o.spp);
  parseTolerance(o.tolerance);
  SimplificationTable table = openTable(o);
  if (o.scenes.empty()) o.scenes = availableScenes();
  requireTableNames(o.scenes);
  TilePool pool(hardwareThreads());
  watchInterrupt();
  try {
    for (const std::string& scene : o.scenes) {
      const auto models = measureScene(o, scene, pool);
      std::erase_if(table.rows, [&](const MeasuredModel& row) { return row.scene == sceneName(scene); });
      table.rows.insert(table.rows.end(), models.begin(), models.end());
      writeSimplificationTable(o.output, table);
    }
  } catch (const Interrupted&) {
    throw std::runtime_error("interrupted; reference frames that are done are kept");
  }
  std::printf("wrote %s\n", o.output.c_str());
}

}  // namespace

void addSimplificationCommand(CLI::App& app) {
  auto o = std::make_shared<SimplificationOptions>();
  o->bench.setup.reference_spp = 256;
  o->bench.frames = "20:21";
  o->bench.repeats = 0;
  auto* c = app.add_subcommand("simplification",
                               "measure what each feature of a scene costs, and how many events it changes");
  addScenesOption(*c, o->scenes);
  addBenchOptions(*c, o->bench);
  c->add_option("--method", o->method,
                "method whose frame times are measured; events are compared on references")
      ->capture_default_str();
  c->add_option("--spp", o->spp, "paths per pixel and frame, for the frame times")
      ->check(NumberIn(ranges::kSpp.min, ranges::kSpp.max))
      ->capture_default_str();
  c->add_option("--tolerance", o->tolerance,
                "print the cheapest model that changes at most this share of the events")
      ->capture_default_str();
  c->add_option("-o,--output", o->output,
                "CSV for `saccaded --simplification`; rows of other scenes stay in it")
      ->capture_default_str();
  c->callback([o] { runSimplification(*o); });
}

}  // namespace saccade::eval
