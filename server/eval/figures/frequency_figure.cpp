// Frequency response at several intensities.
#include <cmath>

#include "eval/figures/sensor_figure.h"
#include "eval/pictures/text.h"
#include "eval/sensor/expectation.h"
#include "eval/sensor/frequency_response.h"

namespace saccade::eval {
namespace {

constexpr double kIntensities[] = {0.01 * kReferenceIntensity, 0.1 * kReferenceIntensity, kReferenceIntensity,
                                   10 * kReferenceIntensity};
constexpr double kMinHz = 1, kMaxHz = 1e4;
constexpr int kFrequencies = 25;
constexpr double kAmplitude = 2;    // in mean thresholds
constexpr double kLeastGain = 0.1;  // drawn of what is expected

std::string describe(double I, const std::vector<FrequencyPoint>& points) {
  const double limit = halfPowerFrequency(points);
  const std::string text = std::isnan(limit) ? format("above %g Hz", kMaxHz) : format("at %.4g Hz", limit);
  return format("intensity %g: -3 dB ", I) + text + "\n";
}

}  // namespace

SensorFigure makeFrequencyFigure(const SensorSetup& setup) {
  const std::vector<double> frequencies = evenInLog(kMinHz, kMaxHz, kFrequencies);
  const double amplitude = kAmplitude * (setup.config.threshold + setup.config.threshold_off) / 2;
  Progress progress("frequency", static_cast<double>(std::size(kIntensities) * frequencies.size()));
  SensorFigure figure{"intensity,hz,on_per_cycle,off_per_cycle,gain,expected_gain\n", "", {}};
  ChartPanel panel{
      "frequency response", "frequency, Hz", "amplitude of the events over that of the picture", {}};
  for (const double I : kIntensities) {
    std::vector<FrequencyPoint> points;
    ChartLine line{format("intensity %g", I), {}}, expected{"expected", {}, LineStyle::kReference};
    for (const double hz : frequencies) {
      const FrequencyPoint p = points.emplace_back(measureResponse(setup, I, amplitude, hz));
      const double gain = expectedGain(setup.config, I, p.hz);
      figure.csv += format("%g,%g,%g,%g,%g,%g\n", I, p.hz, p.on_events, p.off_events, p.gain, gain);
      line.points.push_back({p.hz, p.gain, ""});
      if (gain >= kLeastGain) expected.points.push_back({p.hz, gain, ""});
      progress.add(1);
    }
    figure.summary += describe(I, points);
    panel.lines.push_back(std::move(line)), panel.lines.push_back(std::move(expected));
  }
  fitScale(panel);
  figure.panels = {panel};
  return figure;
}

}  // namespace saccade::eval
