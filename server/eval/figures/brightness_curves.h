// Writes the brightness of one pixel over time, and its spectrum, as tables and charts.
#pragma once

#include <string>
#include <vector>

#include "eval/bench/sequence.h"
#include "eval/figures/figure.h"
#include "eval/pictures/svg_chart.h"

namespace saccade::eval {

struct BrightnessCurve {
  std::string name;
  LineStyle style;
  BrightnessSequence L;
};

struct Pixel {
  int x = 0, y = 0;
};

// The pixel at the quantile kTypicalSpan of the span of brightness, among those that show a smooth surface in
// every frame (else among all). Light moves over it, but no edge.
Pixel typicalPixel(const std::vector<Truth>& truth, const BrightnessSequence& L);
inline constexpr double kTypicalSpan = 0.75;

// Writes three files of the curves of one scene, figure<number>_<scene>: _time.csv, _spectrum.csv and .svg
// with both. The first has L at the pixel, a column for each curve. The second has the power density of L by
// frequency, the mean over the pixels within kSpectrumReach of it in x and in y. Throws std::runtime_error.
void writeBrightness(const FigureOptions& o, const std::string& scene,
                     const std::vector<BrightnessCurve>& curves, Pixel pixel, double rate_hz);
inline constexpr int kSpectrumReach = 4;

}  // namespace saccade::eval
