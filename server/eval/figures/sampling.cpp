#include "eval/change_pictures.h"
#include "eval/figures/figure.h"
#include "eval/open_scene.h"
#include "eval/results.h"
#include "render/simplify.h"

namespace saccade {
namespace {

struct Sampling {
  const char* name;
  Bench bench;
};

void sampleOn(const std::string& scene, const FigureOptions& o, TilePool& pool, ResultTable& table) {
  const auto with_mips = openScene(scene);
  const auto without =
      std::make_shared<RenderScene>(simplified(with_mips->description(), {Part::kMipFiltering}));
  BenchSetup centre = o.bench.setup;
  centre.scene = scene, centre.jitter = false, centre.reference_spp = 0;
  BenchSetup jittered = centre, true_setup = o.bench.setup;
  jittered.jitter = true;
  true_setup.scene = scene, true_setup.jitter = true;
  const Bench truth(true_setup, without, pool);
  const Sampling samplings[] = {{"centre, no mips", {centre, without, pool}},
                                {"centre, mips", {centre, with_mips, pool}},
                                {"jitter, mips", {jittered, with_mips, pool}}};

  ChangePictures pictures(truth.truth().back().change, static_cast<float>(o.bench.bias), o.bench.threshold);
  Progress progress(scene, static_cast<double>(o.methods.size() * std::size(samplings)));
  for (const std::string& text : o.methods) {
    for (const Sampling& s : samplings) {
      const MethodSpec method = parseMethod(text);
      const Result& result =
          measure(truth, s.bench, scene + ": " + s.name, method, o.spp.front(), o.bench, table);
      pictures.add(text + ", " + s.name, s.bench.run(method, o.spp.front(), 1).changes.back(), &result.score);
      progress.add(1);
    }
  }
  pictures.add("mean over the pixel", truth.truth().back().change, nullptr);
  writePicture(o, "_" + scene + ".svg", pictures.draw());
}

}  // namespace

void runSampling(const FigureOptions& o, TilePool& pool) {
  ResultTable table(o.path(".csv"), o.bench.text());
  for (const std::string& scene : o.scenes) sampleOn(scene, o, pool, table);
  printTable(table);
}

}  // namespace saccade
