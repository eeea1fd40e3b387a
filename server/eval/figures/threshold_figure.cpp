// The S-curve: the share of pixels that answer, against the size of the step.
#include <cmath>

#include "eval/figures/sensor_figure.h"
#include "eval/pictures/text.h"
#include "eval/sensor/expectation.h"
#include "eval/sensor/threshold.h"

namespace saccade::eval {
namespace {

constexpr int kSteps = 50;
constexpr double kMaxStep = 2.5;  // in mean thresholds

struct ThresholdRow {
  double step;             // size of the change, > 0
  double answers, within;  // at any level, and after an event
  double expected_answers, expected_within;
};

struct Polarity {
  std::vector<double> thresholds;  // of the pixels
  std::vector<ThresholdRow> rows;
};

Polarity measurePolarity(const SensorSetup& setup, int sign, Progress& progress) {
  const SensorConfig& config = setup.config;
  constexpr double I = kReferenceIntensity;
  Polarity measured{pixelThresholds(setup, I, sign), {}};
  for (int i = 1; i <= kSteps; ++i) {
    const double step = kMaxStep * i / kSteps * (config.threshold + config.threshold_off) / 2;
    measured.rows.push_back(
        {step, shareAnswering(setup, I, sign * step), shareWithin(measured.thresholds, step, setup.pixels()),
         expectedAnswers(config, I, sign * step), expectedWithin(config, I, sign * step)});
    progress.add(1);
  }
  return measured;
}

// The step that a share of the pixels answers at any level, interpolated; NaN where it is never reached.
double answeredStep(const std::vector<ThresholdRow>& rows, double share) {
  double step = 0, before = 0;
  for (const ThresholdRow& row : rows) {
    if (row.answers >= share) return step + (row.step - step) * (share - before) / (row.answers - before);
    step = row.step, before = row.answers;
  }
  return std::nan("");
}

// `at`: the step of a share of the pixels.
template <class At>
std::string describe(const char* polarity, const char* where, At at) {
  return format("%-3s %-15s 50 %% at %.4f, width %.4f\n", polarity, where, at(0.5),
                (at(0.84) - at(0.16)) / 2);
}

std::string describe(const char* polarity, const Polarity& measured, int pixels) {
  const auto any_level = [&](double share) { return answeredStep(measured.rows, share); };
  const auto after_event = [&](double share) { return changeOfShare(measured.thresholds, share, pixels); };
  return describe(polarity, "at any level", any_level) + describe(polarity, "after an event", after_event);
}

ChartLine lineOf(const char* name, const std::vector<ThresholdRow>& rows, double ThresholdRow::*shares,
                 LineStyle style) {
  ChartLine line{name, {}, style};
  for (const ThresholdRow& row : rows) line.points.push_back({row.step, row.*shares, ""});
  return line;
}

ChartPanel panelOf(const char* title, const std::vector<ThresholdRow>& on,
                   const std::vector<ThresholdRow>& off, double ThresholdRow::*measured,
                   double ThresholdRow::*expected) {
  ChartPanel panel{title, "size of the step, log units", "share of the pixels with an event", {}};
  panel.x_scale = panel.y_scale = Scale::kLinear;
  panel.lines = {lineOf("ON", on, measured, LineStyle::kLineAndMarks),
                 lineOf("OFF", off, measured, LineStyle::kLineAndMarks),
                 lineOf("expected", on, expected, LineStyle::kReference),
                 lineOf("expected", off, expected, LineStyle::kReference)};
  return panel;
}

std::string csvOf(const std::vector<ThresholdRow>& on, const std::vector<ThresholdRow>& off) {
  std::string csv =
      "step,on_any_level,off_any_level,on_after_event,off_after_event,on_any_level_expected,"
      "off_any_level_expected,on_after_event_expected,off_after_event_expected\n";
  for (std::size_t i = 0; i < on.size(); ++i) {
    csv += format("%g,%g,%g,%g,%g,%g,%g,%g,%g\n", on[i].step, on[i].answers, off[i].answers, on[i].within,
                  off[i].within, on[i].expected_answers, off[i].expected_answers, on[i].expected_within,
                  off[i].expected_within);
  }
  return csv;
}

}  // namespace

SensorFigure makeThresholdFigure(const SensorSetup& setup) {
  Progress progress("threshold", 2 * kSteps);
  const Polarity on = measurePolarity(setup, 1, progress), off = measurePolarity(setup, -1, progress);
  using Row = ThresholdRow;
  return {csvOf(on.rows, off.rows),
          describe("ON", on, setup.pixels()) + describe("OFF", off, setup.pixels()),
          {panelOf("a step at any level", on.rows, off.rows, &Row::answers, &Row::expected_answers),
           panelOf("a change after an event", on.rows, off.rows, &Row::within, &Row::expected_within)}};
}

}  // namespace saccade::eval
