#include "eval/bench/open_scene.h"
#include "eval/bench/results.h"
#include "eval/figures/change_pictures.h"
#include "eval/figures/figure.h"

namespace saccade::eval {
namespace {

void compareOn(const std::string& scene, const FigureOptions& o, TilePool& pool, ResultTable& table) {
  BenchSetup setup = o.bench.setup;
  setup.scene = scene;
  const Bench bench(setup, pool);
  const IntensityChange& truth = bench.truth().back().change;
  ChangePictures pictures(truth, static_cast<float>(o.bench.bias), o.bench.threshold);
  Progress progress(scene, static_cast<double>(o.methods.size() * o.spp.size()));
  for (const int spp : o.spp) {
    for (const std::string& text : o.methods) {
      const MethodSpec method = parseMethod(text);
      const Result result = measure(bench, sceneName(scene), method, spp, o.bench, table);
      pictures.addMethod(text + ", " + std::to_string(spp) + " spp", bench.run(method, spp, 1).changes.back(),
                         result.score);
      progress.add(1);
    }
  }
  pictures.addReference("reference", truth, bench.referenceError());
  writePicture(o, "_" + sceneName(scene) + ".svg", pictures.draw());
}

}  // namespace

void runComparison(const FigureOptions& o, TilePool& pool) {
  ResultTable table(o.path(".csv"), o.bench.text());
  for (const std::string& scene : o.scenes) compareOn(scene, o, pool, table);
  printTable(table);
}

}  // namespace saccade::eval
