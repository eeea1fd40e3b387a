#include "eval/sensor/frequency_response.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace saccade::eval {
namespace {

constexpr double kFewestEvents = 1;  // per pixel and cycle: fewer may be noise

}  // namespace

FrequencyPoint measureResponse(const SensorSetup& setup, double I, double amplitude, double hz) {
  const Sine sine = sineOf(I, amplitude, hz);
  double on = 0, off = 0;
  runSensor(setup, sine.frames, [&](const Event& e) {
    if (e.t_ns >= sine.settled.count()) ++(e.p == 1 ? on : off);
  });
  const double cycles = static_cast<double>(setup.pixels()) * sine.measured_cycles;
  on /= cycles, off /= cycles;
  const double C_on = setup.config.threshold, C_off = setup.config.threshold_off;
  const double seen = on + off >= kFewestEvents ? (C_on * on + C_off * off + C_on + C_off) / 4 : 0;
  return {1 / seconds(sine.period), on, off, seen / amplitude};
}

double halfPowerFrequency(const std::vector<FrequencyPoint>& points) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double limit = points.front().gain / std::numbers::sqrt2;
    const FrequencyPoint &a = points[i - 1], &b = points[i];
    if (!(a.gain > limit && b.gain <= limit)) continue;
    const double part = b.gain > 0 ? std::log(a.gain / limit) / std::log(a.gain / b.gain) : 0;
    return a.hz * std::pow(b.hz / a.hz, part);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace saccade::eval
