// Figure 7: brightness over time and by frequency, and scores of the reconstructions of brightness.
#include <cstdio>
#include <sstream>

#include "eval/bench/open_scene.h"
#include "eval/figures/brightness_curves.h"
#include "eval/figures/reconstruction_score.h"
#include "eval/figures/screened_poisson.h"
#include "eval/pictures/text.h"

namespace saccade::eval {
namespace {

// The reconstructions of the table. The curves show the defaults, which have names of one word.
const struct {
  std::string name, reconstruction;
  double cutoff_hz;
} kChoices[] = {
    {"direct", "direct", SensorConfig{}.reconstruction_cutoff_hz},
    {"complementary 0.1 Hz", "complementary", 0.1},
    {"complementary", "complementary", SensorConfig{}.reconstruction_cutoff_hz},
    {"complementary 2 Hz", "complementary", 2},
    {"complementary 5 Hz", "complementary", 5},
    {"kalman", "kalman", SensorConfig{}.reconstruction_cutoff_hz},
};

struct Row {
  std::string scene, method;
  int spp;
  std::string reconstruction;
  double C;
  ReconstructionScore score;
};

// Results so far.
struct Results {
  std::vector<Row> rows;
  std::vector<BrightnessCurve> curves;  // of the scene at hand
};

void addRun(const FigureOptions& o, const std::string& scene, const std::string& method, int spp,
            const ChangeSequence& run, const ChangeSequence& truth, Results& results) {
  for (const auto& [name, reconstruction, cutoff_hz] : kChoices) {
    SensorConfig sensor{.bias = o.bench.bias, .reconstruction = reconstruction};
    sensor.reconstruction_cutoff_hz = cutoff_hz;
    for (const double C : o.thresholds) {
      sensor.threshold = sensor.threshold_off = C;
      results.rows.push_back({scene, method, spp, name, C, scoreReconstruction(run, truth, sensor)});
    }
    const bool curve = name == "direct" || (method == o.methods.front() && name == reconstruction);
    if (spp == o.spp.front() && curve)
      results.curves.push_back({method + " " + name, LineStyle::kLine, brightnessOf(run, sensor)});
  }
  if (spp == o.spp.front() && method == o.methods.front())
    results.curves.push_back(
        {method + " screened Poisson", LineStyle::kLine, screenedPoisson(run, o.bench.bias)});
}

void runScene(const FigureOptions& o, const std::string& scene, TilePool& pool, Results& results) {
  BenchSetup setup = o.bench.setup;
  setup.scene = scene;
  const Bench bench(setup, pool);
  const ChangeSequence truth = sequenceOf(bench.truth());
  const SensorConfig plain{.bias = o.bench.bias, .reconstruction = "direct"};
  results.curves.clear();
  results.curves.push_back({"truth", LineStyle::kReference, brightnessOf(truth, plain)});
  forEachRun(bench, o.methods, o.spp, [&](const std::string& method, int spp, const ChangeSequence& run) {
    addRun(o, sceneName(scene), method, spp, run, truth, results);
  });
  const Pixel pixel = o.pixel->empty() ? typicalPixel(bench.truth(), results.curves.front().L)
                                       : Pixel{o.pixel->at(0), o.pixel->at(1)};
  std::printf("%s: pixel %d,%d, %.2f px per frame, error of the reference's dI %.3f\n",
              sceneName(scene).c_str(), pixel.x, pixel.y, bench.medianPxPerFrame(), bench.referenceError());
  writeBrightness(o, sceneName(scene), results.curves, pixel, setup.frame_rate_hz);
}

// Prints the rows, and returns them as CSV.
std::string tableOf(const FigureOptions& o, const std::vector<Row>& rows) {
  std::ostringstream csv;
  csv << "# " << o.bench.text() << '\n'
      << "scene,method,spp,reconstruction,threshold,false_events,missed_events,count_error,voxel_error,drift,"
         "offset,high_rms\n";
  std::printf("\n%-16s %-18s %3s %-21s %5s %8s %8s %8s %8s %8s %8s %8s\n", "scene", "method", "spp",
              "reconstruction", "C", "false", "missed", "count", "voxel", "drift", "offset", "high rms");
  for (const auto& [scene, method, spp, reconstruction, C, s] : rows) {
    csv << scene << ',' << method << ',' << spp << ',' << reconstruction << ',' << C << ',' << s.false_events
        << ',' << s.missed_events << ',' << s.count_error << ',' << s.voxel_error << ',' << s.drift << ','
        << s.offset << ',' << s.high_rms << '\n';
    std::printf("%-16s %-18s %3d %-21s %5g %8.5f %8.5f %8.4f %8.4f %8.4f %8.4f %8.5f\n", scene.c_str(),
                method.c_str(), spp, reconstruction.c_str(), C, s.false_events, s.missed_events,
                s.count_error, s.voxel_error, s.drift, s.offset, s.high_rms);
  }
  return csv.str();
}

}  // namespace

void runBrightness(const FigureOptions& o, TilePool& pool) {
  const BenchSetup& setup = o.bench.setup;
  const auto inside = [&](const std::vector<int>& p) { return p[0] < setup.width && p[1] < setup.height; };
  if (!o.pixel->empty() && !inside(*o.pixel))
    throw std::runtime_error("--pixel must lie within the picture, which is " + std::to_string(setup.width) +
                             "x" + std::to_string(setup.height));
  Results results;
  for (const std::string& scene : o.scenes) runScene(o, scene, pool, results);
  writeText(o.path(".csv"), tableOf(o, results.rows));
  std::printf("wrote %s\n", o.path(".csv").c_str());
}

}  // namespace saccade::eval
