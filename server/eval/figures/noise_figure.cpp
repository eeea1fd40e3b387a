// Noise events against intensity.
#include "eval/figures/sensor_figure.h"
#include "eval/pictures/text.h"
#include "eval/sensor/expectation.h"

namespace saccade::eval {
namespace {

constexpr double kDuration = 10;  // s

}  // namespace

SensorFigure makeNoiseFigure(const SensorSetup& setup) {
  const std::vector<double> intensities = curveIntensities();
  Progress progress("noise", static_cast<double>(intensities.size()));
  SensorFigure figure{"intensity,on_hz,off_hz,on_expected_hz,off_expected_hz\n", "", {}};
  ChartLine on{"ON", {}}, off{"OFF", {}};
  ChartLine on_expected{"expected", {}, LineStyle::kReference}, off_expected = on_expected;
  for (const double I : intensities) {
    const NoiseRate rate = measureNoise(setup, I, kDuration), expected = expectedNoise(setup.config, I);
    figure.csv += format("%g,%g,%g,%g,%g\n", I, rate.on_hz, rate.off_hz, expected.on_hz, expected.off_hz);
    on.points.push_back({I, rate.on_hz, ""}), off.points.push_back({I, rate.off_hz, ""});
    on_expected.points.push_back({I, expected.on_hz, ""}),
        off_expected.points.push_back({I, expected.off_hz, ""});
    progress.add(1);
  }
  figure.summary =
      format("noise, dark: ON %.4f, OFF %.4f Hz per pixel; bright: ON %.4f, OFF %.4f Hz per pixel\n",
             on.points.front().y, off.points.front().y, on.points.back().y, off.points.back().y);
  ChartPanel panel{"noise",
                   "intensity, scene luminance",
                   "events of a still picture, Hz per pixel",
                   {on, off, on_expected, off_expected}};
  fitScale(panel);
  figure.panels = {panel};
  return figure;
}

}  // namespace saccade::eval
