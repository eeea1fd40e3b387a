#include "eval/sensor/time_error.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace saccade::eval {
namespace {

constexpr TimeNs kNever{-1};

// The time of the first event of each pixel, on a rise after which every pixel has sent one.
std::vector<TimeNs> firstEvents(const SensorSetup& setup, TimeNs interval) {
  constexpr double kIntensity = 1;
  const double size = setup.config.threshold + setup.config.threshold_off;
  std::vector<TimeNs> times(static_cast<std::size_t>(setup.pixels()), kNever);
  runSensor(setup, rampOf(kIntensity, size, kRampFrames * seconds(interval)), [&](const Event& e) {
    TimeNs& first = times[setup.pixelOf(e)];
    if (first == kNever && e.p == 1) first = TimeNs(e.t_ns);
  });
  return times;
}

}  // namespace

double measureTimeError(const SensorSetup& setup, TimeNs interval) {
  SensorSetup exact = setup;
  exact.config.noise.jitter_s = 0;
  const std::vector<TimeNs> moved = firstEvents(setup, interval);
  const std::vector<TimeNs> times = firstEvents(exact, interval);
  double squares = 0;
  int events = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (times[i] == kNever) continue;
    const double error = seconds(moved[i] - times[i]);
    squares += error * error;
    ++events;
  }
  return events > 0 ? std::sqrt(squares / events) : std::numeric_limits<double>::quiet_NaN();
}

double expectedTimeError(const NoiseConfig& noise, TimeNs interval) {
  constexpr double kPi = std::numbers::pi;
  constexpr int kTerms = 20'000;  // enough for T = 1e5 s
  const double T = seconds(interval), spread = kPi * noise.jitter_s / T;
  double sum = 0;
  for (double n = 2 * kTerms - 1; n > 0; n -= 2)
    sum -= std::expm1(-n * n * spread * spread / 2) / std::pow(n, 4);
  return 4 * T / (kPi * kPi) * std::sqrt(sum);
}

}  // namespace saccade::eval
