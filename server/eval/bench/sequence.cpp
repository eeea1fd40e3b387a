#include "eval/bench/sequence.h"

#include <cmath>

#include "base/log_ratio.h"
#include "eval/metrics/brightness_change.h"
#include "eval/metrics/for_each_pixel.h"
#include "events/reconstruction.h"
#include "events/sensor.h"

namespace saccade::eval {

ChangeSequence sequenceOf(const BenchRun& run) {
  ChangeSequence changes;
  for (const IntensityChange& change : run.changes) changes.push_back(&change);
  return changes;
}

ChangeSequence sequenceOf(const std::vector<Truth>& truth) {
  ChangeSequence changes;
  for (const Truth& t : truth) changes.push_back(&t.change);
  return changes;
}

void forEachRun(const Bench& bench, const std::vector<std::string>& methods, const std::vector<int>& spp,
                const RunUse& use) {
  Progress progress(bench.setup().scene, static_cast<double>(methods.size() * spp.size()));
  for (const std::string& method : methods) {
    for (const int n : spp) {
      const BenchRun run = bench.run(parseMethod(method), n, 1);
      use(method, n, sequenceOf(run));
      progress.add(1);
    }
  }
}

std::vector<double> BrightnessSequence::at(int x, int y) const {
  std::vector<double> L{L_start.at(x, y)};
  for (const ImageF& change : dL) L.push_back(L.back() + change.at(x, y));
  return L;
}

BrightnessSequence brightnessOf(const ChangeSequence& changes, const SensorConfig& config) {
  const ImageF& I = changes.front()->I_prev;
  const auto bias = static_cast<float>(config.bias);
  BrightnessSequence brightness{ImageF(I.width(), I.height()), {}};
  forEachPixel(I, [&](int x, int y) {
    brightness.L_start.at(x, y) = std::log(bias + clampTo(I.at(x, y), 0, kMaxLuminance));
  });
  const auto reconstruction = findReconstruction(config.reconstruction)->make(config, I.width(), I.height());
  for (const IntensityChange* change : changes) {
    brightness.dL.push_back(brightnessChange(*change, bias));
    reconstruction->reconstruct(*change, brightness.dL.back());
  }
  return brightness;
}

Events eventsOf(const ChangeSequence& changes, const SensorConfig& config) {
  const ImageF& plane = changes.front()->dI;
  Sensor sensor(config, plane.width(), plane.height());
  SensorOutput out;
  Events all;
  for (const IntensityChange* change : changes) {
    sensor.generate(*change, out);
    all.insert(all.end(), out.events.begin(), out.events.end());
  }
  return all;
}

}  // namespace saccade::eval
