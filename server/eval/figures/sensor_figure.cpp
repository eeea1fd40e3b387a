#include "eval/figures/sensor_figure.h"

#include <algorithm>
#include <cmath>

namespace saccade::eval {

const std::vector<SensorCurve>& sensorCurveTable() {
  static const std::vector<SensorCurve> table{
      {"threshold", "the share of pixels that answer, against the size of a step", makeThresholdFigure},
      {"noise", "events of a still picture, against intensity", makeNoiseFigure},
      {"frequency", "amplitude seen, against the frequency of a sinusoidal brightness", makeFrequencyFigure},
      {"latency", "time from a step to the first event, against intensity", makeLatencyFigure},
      {"jitter", "error of event times, against the frame rate", makeJitterFigure},
      {"readout", "events delivered and lost, and their delay, against the rate offered", makeReadoutFigure},
  };
  return table;
}

std::vector<double> curveIntensities() {
  return evenInLog(1e-4 * kReferenceIntensity, 10 * kReferenceIntensity, 11);
}

std::vector<double> evenInLog(double a, double b, int count) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(a * std::pow(b / a, static_cast<double>(i) / (count - 1)));
  return values;
}

void fitScale(ChartPanel& panel) {
  const auto isPositive = [](const ChartPoint& p) { return p.y > 0; };
  const bool has_positive = std::any_of(panel.lines.begin(), panel.lines.end(), [&](const ChartLine& line) {
    return std::any_of(line.points.begin(), line.points.end(), isPositive);
  });
  panel.y_scale = has_positive ? Scale::kLog : Scale::kLinear;
  for (ChartLine& line : panel.lines) {
    std::erase_if(line.points,
                  [&](const ChartPoint& p) { return std::isnan(p.y) || (has_positive && p.y <= 0); });
  }
}

}  // namespace saccade::eval
