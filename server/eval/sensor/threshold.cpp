#include "eval/sensor/threshold.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "eval/sensor/expectation.h"

namespace saccade::eval {
namespace {

constexpr TimeNs kWindow{50'000'000}, kInterval{1'000'000};  // after a step
constexpr double kRampThresholds = 8;                        // the mean thresholds that a ramp passes
constexpr double kThresholdTime = 20e-3;                     // s, for each of them
constexpr double kThresholdRefractory = 10;                  // or so many refractory periods
constexpr double kThresholdLag = 20;                         // or so many time constants of the photoreceptor

struct SlowRamp {
  double speed, duration_s;  // log units per second
};
// Slow for the pixels at `I`.
SlowRamp slowRamp(const SensorConfig& config, double I) {
  const double time = std::max({kThresholdTime, kThresholdRefractory * seconds(config.refractory),
                                kThresholdLag * lagOf(config.noise, I)});
  return {(config.threshold + config.threshold_off) / 2 / time, kRampThresholds * time};
}

}  // namespace

double shareAnswering(const SensorSetup& setup, double I, double step) {
  std::vector<bool> answered(static_cast<std::size_t>(setup.pixels()));
  runSensor(setup, stepOf(I, step, kWindow, kInterval), [&](const Event& e) {
    if (e.t_ns >= kStepTime.count() && (e.p == 1) == (step > 0)) answered[setup.pixelOf(e)] = true;
  });
  return static_cast<double>(std::count(answered.begin(), answered.end(), true)) / setup.pixels();
}

std::vector<double> pixelThresholds(const SensorSetup& setup, double I, int sign) {
  const SlowRamp ramp = slowRamp(setup.config, I);
  const double refractory = seconds(setup.config.refractory);
  std::vector<std::optional<double>> first(static_cast<std::size_t>(setup.pixels())), second = first;
  runSensor(setup, rampOf(I, sign * ramp.speed * ramp.duration_s, ramp.duration_s), [&](const Event& e) {
    const double t = static_cast<double>(e.t_ns) * 1e-9;
    const bool lag_builds_up = t < ramp.duration_s / kRampThresholds;
    if ((e.p == 1) != (sign > 0) || lag_builds_up) return;
    const std::size_t pixel = setup.pixelOf(e);
    if (!first[pixel])
      first[pixel] = t;
    else if (!second[pixel])
      second[pixel] = t;
  });

  std::vector<double> thresholds;
  for (std::size_t i = 0; i < first.size(); ++i) {
    // A pixel takes its reference when it sees again.
    if (second[i]) thresholds.push_back(ramp.speed * (*second[i] - *first[i] - refractory));
  }
  std::sort(thresholds.begin(), thresholds.end());
  return thresholds;
}

double shareWithin(const std::vector<double>& thresholds, double change, int pixels) {
  const auto end = std::upper_bound(thresholds.begin(), thresholds.end(), change);
  return static_cast<double>(end - thresholds.begin()) / pixels;
}

double changeOfShare(const std::vector<double>& thresholds, double share, int pixels) {
  const auto rank = static_cast<std::size_t>(share * (pixels - 1));
  return rank < thresholds.size() ? thresholds[rank] : std::nan("");
}

}  // namespace saccade::eval
