#include "stability/measure.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "eval/bench/score.h"
#include "eval/metrics/brightness_change.h"
#include "eval/metrics/for_each_pixel.h"
#include "events/sensor.h"

namespace saccade::test {

using namespace eval;
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

BenchSetup setupOf(const StabilityCase& c, const StabilityForm& form) {
  return {.scene = c.scene,
          .trajectory = c.trajectory,
          .objects = c.objects,
          .width = c.width,
          .height = c.height,
          .frame_rate_hz = c.rate_hz,
          .px_per_frame = c.px_per_frame,
          .jitter = c.jitter,
          .mips = c.mips,
          .first = c.last + 1 - std::max(1, c.scored),
          .last = c.last,
          .reference_spp = c.scored > 0 ? form.reference_spp * c.truth_paths : 0,
          .cache = form.cache};
}

BenchSetup startOf(BenchSetup setup) {
  setup.first = setup.last = 1;
  return setup;
}

// The parameters of a client that asks for no more.
SensorConfig sensorOf(const StabilityCase& c) {
  return {.threshold = c.threshold, .threshold_off = c.threshold, .bias = c.bias};
}

// Looks at every frame of a run.
class Watch {
 public:
  explicit Watch(const StabilityCase& c) : Watch(sensorOf(c), c.width, c.height) {}

  void see(const IntensityChange& change) {
    const ImageF dL = reconstructed(change);
    for (const ImageF* plane : {&change.dI, &change.I_prev, &change.I_now, &dL})
      forEachPixel(*plane, [&](int x, int y) { non_finite_ += std::isfinite(plane->at(x, y)) ? 0 : 1; });
    forEachPixel(dL, [&](int x, int y) { L_.at(x, y) += dL.at(x, y); });
    sensor_.generate(change, out_);
    events_ += static_cast<double>(out_.events.size());
    suppressed_ += static_cast<double>(out_.suppressed);
    pixel_frames_ += static_cast<double>(L_.width()) * L_.height();
  }

  void tell(Figures& f) const {
    f.events = events_ / pixel_frames_, f.suppressed = suppressed_ / pixel_frames_;
    f.non_finite = non_finite_;
  }
  const Image<double>& L() const { return L_; }  // as reconstructed, since frame 0

 private:
  Watch(const SensorConfig& sensor, int w, int h)
      : bias_(static_cast<float>(sensor.bias)),
        reconstruction_(findReconstruction(sensor.reconstruction)->make(sensor, w, h)),
        sensor_(sensor, w, h),
        L_(w, h) {}

  ImageF reconstructed(const IntensityChange& change) {
    ImageF dL = brightnessChange(change, bias_);
    reconstruction_->reconstruct(change, dL);
    return dL;
  }

  float bias_;
  std::unique_ptr<Reconstruction> reconstruction_;
  Sensor sensor_;
  SensorOutput out_;
  Image<double> L_;
  double events_ = 0, suppressed_ = 0, non_finite_ = 0, pixel_frames_ = 0;
};

}  // namespace

StabilityBench::StabilityBench(const StabilityCase& c, const StabilityForm& form, TilePool& pool)
    : case_(c), repeats_(form.repeats), bench_(setupOf(c, form), pool) {
  if (c.judged == &Figures::drift) start_.emplace(startOf(setupOf(c, form)), pool);
}

Figures StabilityBench::measure(const MethodSpec& method) const {
  Figures figures{};
  for (const FigureColumn& column : kFigureColumns) figures.*column.value = kNaN;
  Watch watch(case_);
  std::vector<BenchRun> runs;
  runs.push_back(bench_.run(method, kStabilitySpp, 1, [&](const IntensityChange& c) { watch.see(c); }));
  watch.tell(figures);
  if (start_) figures.drift = drift(watch.L());
  if (bench_.truth().empty()) return figures;
  for (int seed = 2; seed <= repeats_; ++seed) runs.push_back(bench_.run(method, kStabilitySpp, seed));
  const Score score = scoreOf(bench_.truth(), runs, case_.bias, case_.threshold);
  figures.false_events = score.false_events, figures.missed_events = score.missed_events;
  figures.wrong_events = score.false_events + score.missed_events;
  figures.dL_l1 = score.dL_l1, figures.sigma_dL = score.sigma_dL;
  return figures;
}

double StabilityBench::drift(const Image<double>& L) const {
  const Truth &last = bench_.truth().back(), &first = start_->truth().front();
  ImageF off(L.width(), L.height());
  forEachPixel(off, [&](int x, int y) {
    const double truth = std::log(case_.bias + last.change.I_now.at(x, y)) -
                         std::log(case_.bias + first.change.I_prev.at(x, y));
    off.at(x, y) = static_cast<float>(std::abs(L.at(x, y) - truth));
  });
  return median(off, last.regions, region::kAnywhere);
}

}  // namespace saccade::test
