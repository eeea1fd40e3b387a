// The standard curves of an event camera, measured, as tables and charts.
#pragma once

#include <string>
#include <vector>

#include "eval/bench/progress.h"
#include "eval/pictures/svg_chart.h"
#include "eval/sensor/sensor_run.h"

namespace saccade::eval {

struct SensorFigure {
  std::string csv;      // a heading, and a row for each measurement
  std::string summary;  // lines for the terminal
  std::vector<ChartPanel> panels;
};

struct SensorCurve {
  const char *name, *what;
  SensorFigure (*make)(const SensorSetup& setup);  // shows its progress
};

// THE list of curves.
const std::vector<SensorCurve>& sensorCurveTable();

// The share of pixels that answer against the size of a step.
SensorFigure makeThresholdFigure(const SensorSetup& setup);
// The rate of noise events against intensity.
SensorFigure makeNoiseFigure(const SensorSetup& setup);
// The amplitude that events tell against frequency.
SensorFigure makeFrequencyFigure(const SensorSetup& setup);
// The time from a step to the first event, against intensity.
SensorFigure makeLatencyFigure(const SensorSetup& setup);
// The error of event times against the frame rate.
SensorFigure makeJitterFigure(const SensorSetup& setup);
// Delivered rate, losses and delay of the readout against the rate of events offered.
SensorFigure makeReadoutFigure(const SensorSetup& setup);

// All intensities that the curves take, in scene luminance.
inline constexpr double kReferenceIntensity = 1;
std::vector<double> curveIntensities();

// `a`, ... `b`, with even steps of their logarithms.
std::vector<double> evenInLog(double a, double b, int count);

// Makes an axis of y logarithmic without its points at 0 or NaN, or linear if no other points are left.
void fitScale(ChartPanel& panel);

}  // namespace saccade::eval
