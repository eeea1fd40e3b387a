#include "eval/figures/figure.h"

namespace saccade::eval {
namespace {

const std::vector<std::string> kMethods{
    "pt",     "pt-correlated", "adaptive_sampling", "adaptive_denoising", "svgf", "svgf:as_falcor=1",
    "a_svgf", "relax",         "event_svgf",        "irradiance_cache"};

BenchOptions frames(const char* range, int repeats) {
  BenchOptions o;
  o.frames = range;
  o.repeats = repeats;
  return o;
}

// The first lies on top in charts, and Figure 7 shows it through every reconstruction.
const std::vector<std::string> kSequenceMethods{"irradiance_cache", "event_svgf",    "svgf",
                                                "svgf:as_falcor=1", "pt-correlated", "pt"};

// A small picture for many frames, which `right` moves by about a third of a pixel each, there and back every
// 100.
BenchOptions sequence() {
  BenchOptions o;
  o.size = "64x64", o.frames = "1:256";
  o.setup.reference_spp = 1024;
  o.repeats = 0, o.threshold = 0;
  return o;
}

std::vector<std::string> sweepSigmaL() {
  std::vector<std::string> specs;
  for (const char* sigma : {"1", "2", "4", "10", "20", "40"})
    specs.push_back(std::string("event_svgf:sigma_l=") + sigma + ":sigma_l_diff=" + sigma);
  return specs;
}

}  // namespace

const std::vector<Figure>& figureTable() {
  static const std::vector<Figure> table{
      {{5, sequence(), {"cornell-bunny"}, kSequenceMethods, {2, 8}, {}, {0.05, 0.1, 0.2, 0.5}},
       "false events against the noise of dL, at several thresholds",
       runNoiseLaw},
      {{6, frames("17:21", 2), {}, kMethods, {2, 4, 32}},
       "every method side by side, on every scene",
       runComparison},
      {{7, sequence(), {"cornell-bunny"}, kSequenceMethods, {2}, {}, {0.1, 0.2, 0.5}, std::vector<int>{}},
       "brightness of one pixel over time and by frequency; reconstructions of brightness compared",
       runBrightness},
      {{8, frames("1:3", 2), {"cornell-bunny"}, {"pt", "pt-correlated"}, {2, 4, 8, 32, 128, 512}},
       "path tracing with and without correlated seeds, against the paths per pixel",
       runComparison},
      {{9,
        frames("17:21", 2),
        {"textured-cornell-box"},
        {"event_svgf:correlated=0", "event_svgf:w_prev=0", "event_svgf:accumulate_difference=0",
         "event_svgf:demodulate=0", "event_svgf:correction=0", "event_svgf"},
        {2}},
       "EventSVGF with one part switched off",
       runComparison},
      {{10,
        frames("21", 4),
        {"cornell-bunny"},
        {"irradiance_cache", "event_svgf", "svgf", "svgf:as_falcor=1"},
        {2},
        {0.1, 0.25, 0.33, 0.67, 1, 1.5, 2, 4, 8, 16}},
       "errors against the speed of the camera, to the right and forward",
       runSpeeds},
      {{11, frames("17:21", 2), {"cornell-bunny"}, sweepSigmaL(), {2}},
       "EventSVGF with other luminance tolerances",
       runComparison},
      {{12,
        frames("17:21", 2),
        {"textured-cornell-box"},
        {"irradiance_cache", "event_svgf", "svgf", "pt-correlated"},
        {2}},
       "fine texture: pixel centres without and with mips, and paths from all over the pixel",
       runSampling},
  };
  return table;
}

}  // namespace saccade::eval
