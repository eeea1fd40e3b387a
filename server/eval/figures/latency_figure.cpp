// Latency and its spread against intensity.
#include "eval/figures/sensor_figure.h"
#include "eval/pictures/text.h"
#include "eval/sensor/expectation.h"
#include "eval/sensor/latency.h"

namespace saccade::eval {
namespace {

constexpr double kStep = 3;  // in mean thresholds, so that every pixel answers

struct LatencyRow {
  double I;
  Latency measured, expected;
};

std::vector<LatencyRow> measureRows(const SensorSetup& setup, double step, Progress& progress) {
  std::vector<LatencyRow> rows;
  for (const double I : curveIntensities()) {
    const auto expected = [&](double quantile) { return expectedLatency(setup.config, I, step, quantile); };
    rows.push_back({I,
                    measureLatency(setup, I, step),
                    {expected(0.5), expected(0.16), expected(0.84), expectedAnswers(setup.config, I, step)}});
    progress.add(1);
  }
  return rows;
}

double medianOf(const Latency& latency) {
  return latency.median_s;
}

double spreadOf(const Latency& latency) {
  return (latency.high_s - latency.low_s) / 2;
}

ChartLine lineOf(const char* name, const std::vector<LatencyRow>& rows, Latency LatencyRow::*which,
                 double (*figure)(const Latency&), LineStyle style) {
  ChartLine line{name, {}, style};
  for (const LatencyRow& row : rows) line.points.push_back({row.I, figure(row.*which), ""});
  return line;
}

ChartPanel panelOf(const char* title, const char* y_label, const std::vector<LatencyRow>& on,
                   const std::vector<LatencyRow>& off, double (*figure)(const Latency&)) {
  ChartPanel panel{title, "intensity before the step, scene luminance", y_label, {}};
  panel.lines = {lineOf("ON", on, &LatencyRow::measured, figure, LineStyle::kLineAndMarks),
                 lineOf("OFF", off, &LatencyRow::measured, figure, LineStyle::kLineAndMarks),
                 lineOf("expected", on, &LatencyRow::expected, figure, LineStyle::kReference),
                 lineOf("expected", off, &LatencyRow::expected, figure, LineStyle::kReference)};
  fitScale(panel);
  return panel;
}

std::string csvRow(const Latency& l) {
  return format(",%g,%g,%g,%g", l.median_s, l.low_s, l.high_s, l.answered);
}

}  // namespace

SensorFigure makeLatencyFigure(const SensorSetup& setup) {
  Progress progress("latency", 2 * static_cast<double>(curveIntensities().size()));
  const double step = kStep * (setup.config.threshold + setup.config.threshold_off) / 2;
  const auto on = measureRows(setup, step, progress), off = measureRows(setup, -step, progress);
  SensorFigure figure{
      "intensity,on_median_s,on_low_s,on_high_s,on_answered,off_median_s,off_low_s,off_high_s,off_answered,"
      "on_median_expected_s,off_median_expected_s\n",
      "",
      {panelOf("latency", "time to the first event, median, s", on, off, medianOf),
       panelOf("spread of the latency", "half the range of 16 to 84 % of the pixels, s", on, off, spreadOf)}};
  for (std::size_t i = 0; i < on.size(); ++i) {
    figure.csv += format("%g", on[i].I) + csvRow(on[i].measured) + csvRow(off[i].measured) +
                  format(",%g,%g\n", on[i].expected.median_s, off[i].expected.median_s);
    figure.summary += format("intensity %-8.3g latency ON %.6f s, spread %.6f s; OFF %.6f s, spread %.6f s\n",
                             on[i].I, on[i].measured.median_s, spreadOf(on[i].measured),
                             off[i].measured.median_s, spreadOf(off[i].measured));
  }
  return figure;
}

}  // namespace saccade::eval
