#include "eval/bench/model_bench.h"

#include <cmath>
#include <map>

#include "base/quantile.h"
#include "eval/bench/open_scene.h"
#include "eval/metrics/brightness_change.h"
#include "eval/metrics/for_each_pixel.h"

namespace saccade::eval {
namespace {

constexpr int kRounds = 5;

// The mean of rates(f) over frames f.
template <class Rates>
EventRates meanOver(std::size_t frames, Rates rates) {
  EventRates mean;
  for (std::size_t f = 0; f < frames; ++f) {
    const EventRates r = rates(f);
    mean.false_events += r.false_events / static_cast<double>(frames);
    mean.missed_events += r.missed_events / static_cast<double>(frames);
  }
  return mean;
}

}  // namespace

ModelBench::Brightness::Brightness(const Truth& truth, float bias)
    : dL(brightnessChange(truth.change, bias)),
      half_a(brightnessChange(truth.half_a, truth.change.I_prev, bias)),
      half_b(brightnessChange(truth.half_b, truth.change.I_prev, bias)) {}

ModelBench::ModelBench(const BenchOptions& o, const MethodSpec& method, int spp, TilePool& pool)
    : method_(method),
      spp_(spp),
      bias_(static_cast<float>(o.bias)),
      threshold_(o.threshold),
      whole_(o.setup, pool) {
  for (const Truth& truth : whole_.truth()) frames_.emplace_back(truth, bias_);
  const ImageF nothing(o.setup.width, o.setup.height);
  events_ = meanOver(frames_.size(), [&](std::size_t f) {
              return integratedRates(frames_[f].dL, nothing, threshold_);
            }).false_events;  // [E (31)]
  noise_ = share(meanOver(frames_.size(), [&](std::size_t f) {
    return integratedRates(frames_[f].half_a, frames_[f].half_b, threshold_);
  }));
  std::vector<double> times;
  for (int round = 1; round <= kRounds; ++round) times.push_back(timeOf(whole_, round));
  whole_ms_ = quantile(times, 0.5);
}

double ModelBench::share(const EventRates& rates) const {
  const double both = rates.false_events + rates.missed_events;
  return both == 0 ? 0 : events_ > 0 ? both / events_ : 1;
}

// CPU ms per frame.
double ModelBench::timeOf(const Bench& bench, int round) const {
  return bench.run(method_, spp_, static_cast<std::uint64_t>(round)).cpu_ms;
}

// The CPU time of each, divided by that of the whole model: the median over rounds in which all run in turn.
std::vector<double> ModelBench::relativeTimes(const std::vector<Bench>& benches) const {
  std::vector<std::vector<double>> relative(benches.size());
  Progress progress("times of " + whole_.setup().scene, kRounds);
  for (int round = 1; round <= kRounds; ++round) {
    const double whole_ms = timeOf(whole_, round);
    for (std::size_t i = 0; i < benches.size(); ++i)
      relative[i].push_back(timeOf(benches[i], round) / whole_ms);
    progress.add(1);
  }
  std::vector<double> medians;
  for (std::vector<double>& r : relative) medians.push_back(quantile(r, 0.5));
  return medians;
}

MeasuredModel ModelBench::whole() const {
  return {
      .scene = sceneName(whole_.setup().scene), .model = {whole_.setup().bounces, {}}, .cpu_ms = whole_ms_};
}

MeasuredModel ModelBench::jittered() const {
  std::vector<Bench> benches;
  benches.emplace_back(whole_, true);
  MeasuredModel model = whole();
  model.cpu_ms *= relativeTimes(benches).front();
  compare(benches.front(), model);
  return model;
}

std::vector<MeasuredModel> ModelBench::measure(const std::vector<SceneModel>& models) const {
  std::map<SceneFeatures, std::shared_ptr<const RenderScene>> scenes{{{}, whole_.scene()}};
  std::vector<Bench> benches;
  for (const SceneModel& model : models) {
    auto& scene = scenes[model.disabled_features];
    if (!scene) scene = std::make_shared<RenderScene>(simplified(description(), model.disabled_features));
    benches.emplace_back(whole_, scene, model.bounces);
  }
  const std::vector<double> times = relativeTimes(benches);
  std::vector<MeasuredModel> measured;
  for (std::size_t i = 0; i < models.size(); ++i) {
    measured.push_back(whole());
    measured.back().model = models[i];
    measured.back().cpu_ms *= times[i];
    compare(benches[i], measured.back());
  }
  return measured;
}

// Fills in the events that change, and how many change by noise alone. Let d = dL(simpler) - dL(whole), and
// d_a, d_b the same of the two halves. Then n = (d_a - d_b) / 2 has the variance of d, and the events between
// whole + n and whole are those of the noise. Noise is subtracted in squares, as variances are: so measured,
// a bounce of cornell-box changes the same from 64 to 4096 paths.
void ModelBench::compare(const Bench& bench, MeasuredModel& model) const {
  EventRates noise;
  const EventRates rates = meanOver(frames_.size(), [&](std::size_t f) {
    const Brightness &whole = frames_[f], simpler(bench.truth()[f], bias_);
    ImageF noisy(whole.dL.width(), whole.dL.height());
    forEachPixel(noisy, [&](int x, int y) {
      const auto difference = [&](ImageF Brightness::*half) {
        return (simpler.*half).at(x, y) - (whole.*half).at(x, y);
      };
      noisy.at(x, y) =
          whole.dL.at(x, y) + (difference(&Brightness::half_a) - difference(&Brightness::half_b)) / 2;
    });
    const EventRates r = integratedRates(noisy, whole.dL, threshold_);
    noise.false_events += r.false_events, noise.missed_events += r.missed_events;
    return integratedRates(simpler.dL, whole.dL, threshold_);
  });
  model.false_events = rates.false_events, model.missed_events = rates.missed_events;
  model.noise = share(noise) / static_cast<double>(frames_.size());
  model.changed = std::sqrt(std::max(0.0, share(rates) * share(rates) - model.noise * model.noise));
}

}  // namespace saccade::eval
