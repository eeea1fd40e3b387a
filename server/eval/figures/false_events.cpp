#include "eval/figures/false_events.h"

#include <cmath>

#include "eval/metrics/event_rates.h"
#include "eval/metrics/for_each_pixel.h"
#include "events/sensor.h"
#include "saccade/wire/ranges.h"

namespace saccade::eval {
namespace {

// Mean and standard deviation of the values that `within` lets through.
template <class Within>
std::pair<double, double> meanAndSigma(const std::vector<float>& values, Within within) {
  double sum = 0, squares = 0, n = 0;
  for (const double v : values) {
    if (within(v)) sum += v, squares += v * v, ++n;
  }
  const double mean = sum / n;
  return {mean, std::sqrt(std::max(0.0, squares / n - mean * mean))};
}

// dL of method and truth in some pixel-frames, 0 elsewhere.
class PixelFrames {
 public:
  // Those where where(dL, dL_truth).
  template <class Where>
  PixelFrames(const BrightnessSequence& method, const BrightnessSequence& truth, Where where) {
    for (std::size_t f = 0; f < truth.dL.size(); ++f) {
      const ImageF &dL = method.dL[f], &ref = truth.dL[f];
      Frame& frame = frames_.emplace_back(dL.width(), dL.height());
      forEachPixel(dL, [&](int x, int y) {
        ++all_;
        if (!where(dL.at(x, y), ref.at(x, y))) return;
        frame.in.at(x, y) = 1, frame.dL.at(x, y) = dL.at(x, y), frame.ref.at(x, y) = ref.at(x, y);
        noise_.push_back(dL.at(x, y) - ref.at(x, y));
      });
    }
  }

  double share() const { return count() / all_; }
  NoiseSize noise() const { return noiseSize(noise_); }

  // Events of a sensor that sees all of `run`.
  double eventRate(const ChangeSequence& run, const SensorConfig& config) const {
    Sensor sensor(config, frames_.front().dL.width(), frames_.front().dL.height());
    SensorOutput out;
    double events = 0;
    for (std::size_t f = 0; f < run.size(); ++f) {
      sensor.generate(*run[f], out);
      for (const Event& e : out.events) events += frames_[f].in.at(e.x, e.y);
    }
    return events / count();
  }

  double falseAndMissed(double C) const {
    double events = 0;
    for (std::size_t f = 0; f < frames_.size(); ++f) {
      const EventRates rates = sampledRates(frames_[f].dL, frames_[f].ref, C, f);
      events += (rates.false_events + rates.missed_events) * all_ / static_cast<double>(frames_.size());
    }
    return events / count();
  }

 private:
  struct Frame {
    Frame(int w, int h) : in(w, h), dL(w, h), ref(w, h) {}
    Image<std::uint32_t> in;
    ImageF dL, ref;
  };
  double count() const { return static_cast<double>(noise_.size()); }

  std::vector<Frame> frames_;
  std::vector<float> noise_;
  double all_ = 0;  // pixel-frames
};

MovingEvents movingEvents(const PixelFrames& pixels, double C) {
  return {pixels.share(), pixels.noise(), pixels.falseAndMissed(C)};
}

}  // namespace

NoiseSize noiseSize(const std::vector<float>& noise) {
  if (noise.empty()) return {};
  NoiseSize size;
  for (const float n : noise) size.mean_abs += std::abs(n) / static_cast<double>(noise.size());
  const auto [mean, sigma] = meanAndSigma(noise, [](double) { return true; });
  size.sigma = sigma;
  const auto usual = [m = mean, s = sigma](double v) { return std::abs(v - m) <= kOutlierSigmas * s; };
  size.sigma_trimmed = meanAndSigma(noise, usual).second;
  return size;
}

FalseEvents countFalseEvents(const ChangeSequence& run, const ChangeSequence& truth, double bias, double C) {
  SACCADE_CHECK(run.size() == truth.size());
  SensorConfig sensor{.threshold = C, .threshold_off = C, .bias = bias, .reconstruction = "direct"};
  sensor.max_events_per_pixel_frame = ranges::kMaxPixelEvents.max;  // the law knows no bound
  const BrightnessSequence dL = brightnessOf(run, sensor), ref = brightnessOf(truth, sensor);
  const PixelFrames quiet(dL, ref, [&](float, float r) { return std::abs(r) <= kQuiet * C; });
  const PixelFrames all(dL, ref, [](float, float) { return true; });
  const PixelFrames small(dL, ref, [&](float d, float r) { return std::abs(d) + std::abs(r) <= C; });
  FalseEvents counted{{quiet.share(), quiet.noise()}, movingEvents(all, C), movingEvents(small, C)};
  sensor.model = "probabilistic";
  counted.quiet.fresh_phase = quiet.eventRate(run, sensor);
  sensor.model = "accumulating";
  counted.quiet.accumulating = quiet.eventRate(run, sensor);
  return counted;
}

}  // namespace saccade::eval
