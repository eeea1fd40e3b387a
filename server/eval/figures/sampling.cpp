#include "eval/bench/open_scene.h"
#include "eval/bench/results.h"
#include "eval/figures/change_pictures.h"
#include "eval/figures/figure.h"

namespace saccade::eval {
namespace {

struct Sampling {
  const char* name;
  Bench bench;
};

void sampleOn(const std::string& scene, const FigureOptions& o, TilePool& pool, ResultTable& table) {
  BenchSetup true_setup = o.bench.setup;
  true_setup.scene = scene, true_setup.jitter = true, true_setup.mips = false;
  const Bench truth(true_setup, pool);
  const auto sampling = [&](bool jitter, bool mips) {
    BenchSetup setup = true_setup;
    setup.jitter = jitter, setup.mips = mips, setup.reference_spp = 0;
    return Bench(setup, pool);
  };
  const Sampling samplings[] = {{"centre without mips", sampling(false, false)},
                                {"centre with mips", sampling(false, true)},
                                {"jitter with mips", sampling(true, true)}};

  ChangePictures pictures(truth.truth().back().change, static_cast<float>(o.bench.bias), o.bench.threshold);
  Progress progress(scene, static_cast<double>(o.methods.size() * std::size(samplings)));
  for (const std::string& text : o.methods) {
    for (const Sampling& s : samplings) {
      const MethodSpec method = parseMethod(text);
      const Result result =
          measure(truth, s.bench, sceneName(scene) + ": " + s.name, method, o.spp.front(), o.bench, table);
      pictures.addMethod(text + ", " + s.name, s.bench.run(method, o.spp.front(), 1).changes.back(),
                         result.score);
      progress.add(1);
    }
  }
  pictures.addReference("mean over the pixel", truth.truth().back().change, truth.referenceError());
  writePicture(o, "_" + sceneName(scene) + ".svg", pictures.draw());
}

}  // namespace

void runSampling(const FigureOptions& o, TilePool& pool) {
  ResultTable table(o.path(".csv"), o.bench.text());
  for (const std::string& scene : o.scenes) sampleOn(scene, o, pool, table);
  printTable(table);
}

}  // namespace saccade::eval
