#include "eval/figures/brightness_curves.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "eval/figures/spectrum.h"
#include "eval/metrics/for_each_pixel.h"
#include "eval/pictures/text.h"

namespace saccade::eval {
namespace {

bool alwaysSmooth(const std::vector<Truth>& truth, int x, int y) {
  return std::all_of(truth.begin(), truth.end(),
                     [&](const Truth& t) { return t.regions.at(x, y) == region::kSmooth; });
}

double spanOf(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return *high - *low;
}

Spectrum spectrumAround(const BrightnessSequence& L, Pixel pixel, double rate_hz) {
  Spectrum sum;
  double count = 0;
  forEachPixel(L.L_start, [&](int x, int y) {
    if (std::abs(x - pixel.x) > kSpectrumReach || std::abs(y - pixel.y) > kSpectrumReach) return;
    sum += powerSpectrum(L.at(x, y), rate_hz);
    ++count;
  });
  for (double& density : sum.density) density /= count;
  return sum;
}

std::vector<ChartPoint> timePoints(const std::vector<double>& L, double rate_hz) {
  std::vector<ChartPoint> points;
  for (std::size_t t = 0; t < L.size(); ++t) points.push_back({static_cast<double>(t) / rate_hz, L[t], ""});
  return points;
}

std::vector<ChartPoint> spectrumPoints(const Spectrum& spectrum) {
  std::vector<ChartPoint> points;
  for (std::size_t k = 0; k < spectrum.density.size(); ++k)
    points.push_back({spectrum.hz(k), spectrum.density[k], ""});
  return points;
}

// A column for the common x of all lines, and one for each of them.
std::string csvOf(const std::string& x, const ChartPanel& panel) {
  std::ostringstream csv;
  csv << x;
  for (const ChartLine& line : panel.lines) csv << ',' << line.name;
  for (std::size_t i = 0; i < panel.lines.front().points.size(); ++i) {
    csv << '\n' << panel.lines.front().points[i].x;
    for (const ChartLine& line : panel.lines) csv << ',' << line.points[i].y;
  }
  csv << '\n';
  return csv.str();
}

}  // namespace

Pixel typicalPixel(const std::vector<Truth>& truth, const BrightnessSequence& L) {
  struct Candidate {
    double span;
    Pixel pixel;
  };
  std::vector<Candidate> smooth, all;
  forEachPixel(L.L_start, [&](int x, int y) {
    all.push_back({spanOf(L.at(x, y)), {x, y}});
    if (alwaysSmooth(truth, x, y)) smooth.push_back(all.back());
  });
  std::vector<Candidate>& chosen = smooth.empty() ? all : smooth;
  std::stable_sort(chosen.begin(), chosen.end(),
                   [](const Candidate& a, const Candidate& b) { return a.span < b.span; });
  return chosen[static_cast<std::size_t>(kTypicalSpan * static_cast<double>(chosen.size() - 1))].pixel;
}

void writeBrightness(const FigureOptions& o, const std::string& scene,
                     const std::vector<BrightnessCurve>& curves, Pixel pixel, double rate_hz) {
  const std::string where = " pixel " + std::to_string(pixel.x) + "," + std::to_string(pixel.y);
  ChartPanel time{scene + "," + where, "seconds", "brightness L", {}};
  ChartPanel spectrum{scene + ", around" + where, "Hz", "power density of L, 1/Hz", {}};
  time.x_scale = time.y_scale = Scale::kLinear;
  for (const BrightnessCurve& curve : curves) {
    time.lines.push_back({curve.name, timePoints(curve.L.at(pixel.x, pixel.y), rate_hz), curve.style});
    spectrum.lines.push_back(
        {curve.name, spectrumPoints(spectrumAround(curve.L, pixel, rate_hz)), curve.style});
  }
  writeText(o.path("_" + scene + "_time.csv"), csvOf("seconds", time));
  writeText(o.path("_" + scene + "_spectrum.csv"), csvOf("hz", spectrum));
  for (ChartLine& line : spectrum.lines)
    std::erase_if(line.points, [](const ChartPoint& p) { return p.y == 0; });
  writePicture(o, "_" + scene + ".svg", drawCharts({time, spectrum}, 2));
}

}  // namespace saccade::eval
