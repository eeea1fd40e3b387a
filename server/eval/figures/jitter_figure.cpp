// Jitter of event times against the frame rate.
#include <cmath>

#include "eval/figures/sensor_figure.h"
#include "eval/pictures/text.h"
#include "eval/sensor/time_error.h"

namespace saccade::eval {
namespace {

constexpr double kMinHz = 100, kMaxHz = 5e4;
constexpr int kRates = 10;

TimeNs intervalOf(double hz) {
  return std::llround(1e9 / hz / kEventTimeUnit.count()) * kEventTimeUnit;
}

}  // namespace

SensorFigure makeJitterFigure(const SensorSetup& setup) {
  Progress progress("jitter", kRates);
  SensorFigure figure{"frame_rate_hz,error_s,error_expected_s\n", "", {}};
  ChartLine measured{"event times", {}}, expected{"expected", {}, LineStyle::kReference};
  for (const double rate : evenInLog(kMinHz, kMaxHz, kRates)) {
    const TimeNs interval = intervalOf(rate);
    const double hz = 1 / seconds(interval), error = measureTimeError(setup, interval);
    expected.points.push_back({hz, expectedTimeError(setup.config.noise, interval), ""});
    measured.points.push_back({hz, error, ""});
    figure.csv += format("%g,%g,%g\n", hz, error, expected.points.back().y);
    progress.add(1);
  }
  figure.summary = format("jitter, standard deviation: %.2e s at %g Hz, %.2e s at %g Hz\n",
                          measured.points.front().y, kMinHz, measured.points.back().y, kMaxHz);
  ChartPanel panel{
      "jitter", "frames per second", "standard deviation of event times, s", {measured, expected}};
  fitScale(panel);
  figure.panels = {panel};
  return figure;
}

}  // namespace saccade::eval
