// The readout against the rate of events that is offered to it.
#include "eval/figures/sensor_figure.h"
#include "eval/pictures/text.h"
#include "eval/sensor/readout.h"

namespace saccade::eval {
namespace {

constexpr int kRates = 24;  // even: close to full load a queue settles too slowly

struct ReadoutRow {
  double offered_hz;
  ReadoutLoad measured, expected;
};

double delivered(const ReadoutLoad& load) {
  return load.delivered_hz;
}

double lost(const ReadoutLoad& load) {
  return load.queue.lost;
}

double wait(const ReadoutLoad& load) {
  return load.queue.wait_s;
}

ChartPanel panelOf(const char* title, const char* y_label, const std::vector<ReadoutRow>& rows,
                   double (*figure)(const ReadoutLoad&)) {
  ChartLine measured{"events", {}}, expected{"expected", {}, LineStyle::kReference};
  for (const ReadoutRow& row : rows) {
    measured.points.push_back({row.offered_hz, figure(row.measured), ""});
    expected.points.push_back({row.offered_hz, figure(row.expected), ""});
  }
  return {title, "events offered per second", y_label, {measured, expected}};
}

}  // namespace

SensorFigure makeReadoutFigure(const SensorSetup& setup) {
  const NoiseConfig& noise = setup.config.noise;
  const double full_hz = readoutRate(noise);
  Progress progress("readout", kRates);
  std::vector<ReadoutRow> rows;
  for (const double hz : evenInLog(0.1 * full_hz, 10 * full_hz, kRates)) {
    rows.push_back({hz, measureReadout(noise, hz), expectedReadout(noise, hz)});
    progress.add(1);
  }
  SensorFigure figure{
      "offered_hz,delivered_hz,lost,wait_s,delivered_expected_hz,lost_expected,wait_expected_s\n", "", {}};
  for (const auto& [hz, measured, expected] : rows) {
    figure.csv += format("%g,%g,%g,%g,%g,%g,%g\n", hz, delivered(measured), lost(measured), wait(measured),
                         delivered(expected), lost(expected), wait(expected));
  }
  const ReadoutLoad& most = rows.back().measured;
  figure.summary = format("readout: of %.3g events/s it delivers %.3g, after %.2e s\n",
                          rows.back().offered_hz, most.delivered_hz, most.queue.wait_s);
  figure.panels = {panelOf("delivered", "events delivered per second", rows, delivered),
                   panelOf("lost", "share of the events lost", rows, lost),
                   panelOf("delay", "mean wait of an event, s", rows, wait)};
  figure.panels[1].y_scale = figure.panels[2].y_scale = Scale::kLinear;
  return figure;
}

}  // namespace saccade::eval
