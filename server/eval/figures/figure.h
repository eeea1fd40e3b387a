// The figures of the paper as commands, with the settings of each.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "eval/bench/bench_options.h"

namespace saccade::eval {

struct FigureOptions {
  int number = 0;
  BenchOptions bench;
  std::vector<std::string> scenes, methods;
  std::vector<int> spp;
  std::vector<double> speeds = {};             // pixels per frame; empty: the figure has one speed
  std::vector<double> thresholds = {};         // C; empty: the figure has one, that of `bench`
  std::optional<std::vector<int>> pixel = {};  // x, y, or empty: chosen from the truth; none: no flag
  std::string output = {};                     // folder for figure<number>.csv and figure<number>*.svg

  // "<output>/figure<number><rest>"
  std::string path(const std::string& rest) const;
};

struct Figure {
  FigureOptions defaults;
  const char* what;
  void (*run)(const FigureOptions& o, TilePool& pool);  // throws Interrupted, std::runtime_error
};

// THE list of figures.
const std::vector<Figure>& figureTable();

// Methods and spp side by side: each is a row of the table and a column of pictures. Each scene has a file.
void runComparison(const FigureOptions& o, TilePool& pool);
// Texture sampled at pixel centres without and with mips, and all over the pixel. The reference is the mean
// over the pixel without mips.
void runSampling(const FigureOptions& o, TilePool& pool);
// Error, noise and bias against the speed of the camera, in both directions `right` and `forward`.
void runSpeeds(const FigureOptions& o, TilePool& pool);

// Appendix B: false events against the noise of dL.
void runNoiseLaw(const FigureOptions& o, TilePool& pool);
// Brightness over time and by frequency; scores of the reconstructions of brightness.
void runBrightness(const FigureOptions& o, TilePool& pool);

// Writes "<output>/figure<number><rest>" and says so. Throws std::runtime_error.
void writePicture(const FigureOptions& o, const std::string& rest, const std::string& svg);

}  // namespace saccade::eval
