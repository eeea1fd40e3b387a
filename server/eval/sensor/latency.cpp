#include "eval/sensor/latency.h"

#include <limits>
#include <vector>

#include "base/quantile.h"

namespace saccade::eval {
namespace {

constexpr TimeNs kWindow{1'000'000'000};

}  // namespace

Latency measureLatency(const SensorSetup& setup, double I, double step) {
  std::vector<bool> answered(static_cast<std::size_t>(setup.pixels()));
  std::vector<double> times;
  runSensor(setup, stepOf(I, step, kWindow, kEventTimeUnit), [&](const Event& e) {
    if (e.t_ns < kStepTime.count() || (e.p == 1) != (step > 0)) return;
    std::vector<bool>::reference seen = answered[setup.pixelOf(e)];
    if (seen) return;
    seen = true;
    times.push_back(static_cast<double>(e.t_ns - kStepTime.count()) * 1e-9);
  });
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (times.empty()) return {kNone, kNone, kNone, 0};
  return {quantile(times, 0.5), quantile(times, 0.16), quantile(times, 0.84),
          static_cast<double>(times.size()) / setup.pixels()};
}

}  // namespace saccade::eval
