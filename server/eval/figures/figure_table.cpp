#include "eval/bench/compared_methods.h"
#include "eval/figures/figure.h"

namespace saccade::eval {
namespace {

BenchOptions frames(const char* range, int repeats) {
  BenchOptions o;
  o.frames = range;
  o.repeats = repeats;
  return o;
}

// A small picture for many frames, which `right` moves by about a third of a pixel each, there and back every
// 100.
BenchOptions sequence() {
  BenchOptions o;
  o.size = "64x64", o.frames = "1:256";
  o.setup.reference_spp = 1024;
  o.repeats = 0, o.threshold = 0;
  return o;
}

// All methods but one.
std::vector<std::string> without(const std::string& method) {
  std::vector<std::string> methods = comparedMethods();
  std::erase(methods, method);
  return methods;
}

}  // namespace

// Figures 5, 6, 7, 10 and 12 take every method, but adaptive sampling of few paths: it is path tracing then.
// Figure 8 takes path tracing, the methods that are published with many paths, and two of few paths beside
// them. Figure 9 has the parts of EventSVGF, and Figure 11 each method with a tolerance of luminance.
const std::vector<Figure>& figureTable() {
  static const std::vector<std::string> all = comparedMethods(), of_few_paths = without("adaptive_sampling");
  static const std::vector<Figure> table{
      {{5, sequence(), {"cornell-bunny"}, of_few_paths, {2, 8}, {}, {0.05, 0.1, 0.2, 0.5}},
       "false events against the noise of dL, at several thresholds",
       runNoiseLaw},
      {{6, frames("17:21", 2), {}, all, {2, 4, 32}},
       "every method side by side, on every scene",
       runComparison},
      {{7, sequence(), {"cornell-bunny"}, of_few_paths, {2}, {}, {0.1, 0.2, 0.5}, std::vector<int>{}},
       "brightness of one pixel over time and by frequency; reconstructions of brightness compared",
       runBrightness},
      {{8,
        frames("11:12", 2),
        {"cornell-bunny"},
        {"pt", "pt-correlated", "adaptive_denoising", "adaptive_sampling", "event_svgf", "irradiance_cache"},
        {2, 8, 32, 128, 512}},
       "methods of many paths, and path tracing with and without correlated seeds, against the paths",
       runComparison},
      {{9,
        frames("17:21", 2),
        {"textured-cornell-box"},
        {"event_svgf:correlated=0", "event_svgf:w_prev=0", "event_svgf:accumulate_difference=0",
         "event_svgf:demodulate=0", "event_svgf:correction=0", "event_svgf:motion_aligned=1", "event_svgf"},
        {2}},
       "EventSVGF with one part switched off, and with motion alignment",
       runComparison},
      {{10,
        frames("21", 4),
        {"cornell-bunny"},
        of_few_paths,
        {2},
        {0.1, 0.25, 0.33, 0.67, 1, 1.5, 2, 4, 8, 16}},
       "errors against the speed of the camera, to the right and forward",
       runSpeeds},
      {{11, frames("17:21", 2), {"cornell-bunny"}, luminanceSweep({"1", "4", "10", "40"}), {2}},
       "methods with other luminance tolerances",
       runComparison},
      {{12, frames("17:21", 2), {"textured-cornell-box"}, of_few_paths, {2}},
       "fine texture: pixel centres without and with mips, and paths from all over the pixel",
       runSampling},
  };
  return table;
}

}  // namespace saccade::eval
