// `saccade-eval compare` compares dumped frames with those of the reference, in numbers and as a picture.
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>

#include "base/number_in.h"
#include "eval/bench/arguments.h"
#include "eval/bench/dump.h"
#include "eval/commands/commands.h"
#include "eval/metrics/brightness_change.h"
#include "eval/metrics/frame_errors.h"
#include "eval/metrics/noise_free_error.h"
#include "eval/pictures/signed_picture.h"
#include "eval/pictures/text.h"
#include "saccade/wire/ranges.h"

namespace saccade::eval {
namespace {

struct CompareOptions {
  std::string dump, reference, picture;
  double bias = 1e-3, threshold = 0.2;
};

// The numbers of one frame, in the order of the heading.
using Row = std::array<double, 8>;
constexpr const char* kHeading =
    "frame          dI L1   MAPE  dL L1   MAPE  false ev.  missed ev.  false %  missed %  dI_error dI_share "
    "dL_error dL_share";

Row toRow(const FrameErrors& e) {
  return {e.dI_l1,
          e.dI_mape,
          e.dL_l1,
          e.dL_mape,
          e.rates.false_events,
          e.rates.missed_events,
          e.rates.false_pixels,
          e.rates.missed_pixels};
}

// Against the halves of the reference, over the frames that have them.
struct HalvesErrors {
  NoiseFreeError dI, dL;
  double own_events = 0, frames = 0;

  void add(const IntensityChange& x, const ChangeHalves& halves, const CompareOptions& o) {
    const auto bias = static_cast<float>(o.bias);
    const ImageF a = brightnessChange(halves.a, bias), b = brightnessChange(halves.b, bias);
    dI.add(x.dI, halves.a.dI, halves.b.dI);
    dL.add(brightnessChange(x, bias), a, b);
    own_events += ownRate(integratedRates(a, b, o.threshold)), ++frames;
  }
};

std::string numberOrDash(double value) {
  return std::isnan(value) ? "-" : format("%.4f", value);
}

void print(const std::string& name, const Row& r, const HalvesErrors& halves) {
  std::printf("%-12s %7.4f %6.3f %6.4f %6.3f %10.6f %11.6f %8.4f %9.4f", name.c_str(), r[0], r[1], r[2], r[3],
              r[4], r[5], 100 * r[6], 100 * r[7]);
  for (const NoiseFreeError* e : {&halves.dI, &halves.dL})
    std::printf(" %9s %8s", numberOrDash(e->relative()).c_str(), numberOrDash(e->share()).c_str());
  std::puts("");
}

void checkSize(const std::string& name, const IntensityChange& x, const IntensityChange& ref) {
  const auto size = [](const ImageF& p) { return format("%dx%d", p.width(), p.height()); };
  if (size(x.dI) != size(ref.dI))
    throw std::runtime_error(name + " is " + size(x.dI) + ", not " + size(ref.dI));
}

void writeComparison(const CompareOptions& o, const ImageF& dI, const ImageF& ref) {
  ImageF difference(ref.width(), ref.height());
  for (int y = 0; y < ref.height(); ++y) {
    for (int x = 0; x < ref.width(); ++x) difference.at(x, y) = dI.at(x, y) - ref.at(x, y);
  }
  const float scale = colorScale(ref);
  const auto cell = [&](const ImageF& plane) { return signedPicture(plane, scale, ""); };
  writeText(o.picture, drawPictureGrid({o.dump, o.reference + ", (reference)", "difference"},
                                       {format("dI, full colour %.3g", static_cast<double>(scale))},
                                       {{cell(dI), cell(ref), cell(difference)}}, kChangeKey));
}

void runCompare(const CompareOptions& o) {
  if (!o.picture.empty()) checkOutputFile(o.picture, {".svg"});
  const std::vector<int> frames = commonFrames(o.dump, o.reference);
  std::puts(kHeading);
  Row mean{};
  HalvesErrors all;
  for (const int frame : frames) {
    const IntensityChange x = readChange(o.dump, frame), ref = readChange(o.reference, frame);
    const std::string name = format("dI_%05d.exr", frame);
    checkSize(o.dump + '/' + name, x, ref);
    const Row row = toRow(frameErrors(x, ref, static_cast<float>(o.bias), o.threshold));
    HalvesErrors halves;
    if (const auto read = readHalves(o.reference, frame)) halves.add(x, *read, o), all.add(x, *read, o);
    print(name, row, halves);
    for (std::size_t i = 0; i < row.size(); ++i) mean[i] += row[i] / static_cast<double>(frames.size());
    if (!o.picture.empty() && frame == frames.back()) writeComparison(o, x.dI, ref.dI);
  }
  print("mean", mean, all);
  if (all.frames > 0)
    std::printf("of these, %.6f false and as many missed events are noise of the reference\n",
                all.own_events / all.frames);
}

}  // namespace

void addCompareCommand(CLI::App& app) {
  auto o = std::make_shared<CompareOptions>();
  auto* command = app.add_subcommand(
      "compare",
      "compare two dumps: print relative L1 and MAPE of dI and dL, false and missed events per "
      "pixel and frame, and the share of pixels with any (means over the threshold phase); "
      "with a reference also the noise-free errors and the share of the true change that arrives; draw a "
      "picture");
  command->add_option("dump", o->dump, "folder written by frames --dump")
      ->required()
      ->check(CLI::ExistingDirectory);
  command->add_option("reference", o->reference, "folder written by frames --reference --dump")
      ->required()
      ->check(CLI::ExistingDirectory);
  command->add_option("--bias", o->bias, "I_eps, scene luminance")
      ->check(NumberIn(ranges::kBias.min, ranges::kBias.max))
      ->capture_default_str();
  command->add_option("--threshold", o->threshold, "contrast threshold of both polarities, natural log units")
      ->check(NumberIn(ranges::kThreshold.min, ranges::kThreshold.max))
      ->capture_default_str();
  command->add_option("-o,--output", o->picture,
                      "SVG picture of the last frame's dI: dump, reference and difference");
  command->callback([o] { runCompare(*o); });
}

}  // namespace saccade::eval
