// `saccade-eval compare` compares dumped frames with those of the reference, in numbers and as a picture.
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "base/number_in.h"
#include "eval/bench/arguments.h"
#include "eval/commands/commands.h"
#include "eval/metrics/frame_errors.h"
#include "eval/pictures/signed_picture.h"
#include "eval/pictures/text.h"
#include "saccade/wire/ranges.h"

namespace saccade::eval {
namespace {

namespace fs = std::filesystem;

struct CompareOptions {
  std::string dump, reference, picture;
  double bias = 1e-3, threshold = 0.2;
};

// The numbers of one frame, in the order of the heading.
using Row = std::array<double, 8>;
constexpr const char* kHeading =
    "frame          dI L1   MAPE  dL L1   MAPE  false ev.  missed ev.  false %  missed %";

void print(const std::string& name, const Row& r) {
  std::printf("%-12s %7.4f %6.3f %6.4f %6.3f %10.6f %11.6f %8.4f %9.4f\n", name.c_str(), r[0], r[1], r[2],
              r[3], r[4], r[5], 100 * r[6], 100 * r[7]);
}

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

ImageF readLuminance(const fs::path& file) {
  ExrPicture picture = readExr(file.string());
  const auto plane = picture.planes.find("Y");
  if (plane == picture.planes.end()) throw std::runtime_error(file.string() + " has no channel Y");
  return std::move(plane->second);
}

void checkSize(const fs::path& file, const ImageF& plane, int width, int height) {
  if (plane.width() == width && plane.height() == height) return;
  throw std::runtime_error(file.string() + " is " + std::to_string(plane.width()) + "x" +
                           std::to_string(plane.height()) + ", not " + std::to_string(width) + "x" +
                           std::to_string(height));
}

// The change in dI_<number> and Iprev_<number>, from a folder that frames --dump wrote.
IntensityChange readChange(const std::string& folder, const std::string& number, int width, int height) {
  IntensityChange change(width, height);
  for (const auto& [name, plane] : {std::pair{"dI_", &change.dI}, {"Iprev_", &change.I_prev}}) {
    const fs::path file = fs::path(folder) / (name + number);
    ImageF read = readLuminance(file);
    checkSize(file, read, width, height);
    *plane = std::move(read);
  }
  return change;
}

// The "00001.exr" of each dI_00001.exr that both folders have, sorted.
std::vector<std::string> commonFrames(const CompareOptions& o) {
  std::vector<std::string> frames;
  for (const auto& entry : fs::directory_iterator(o.dump)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("dI_") && fs::exists(fs::path(o.reference) / name)) frames.push_back(name.substr(3));
  }
  std::sort(frames.begin(), frames.end());
  if (frames.empty()) throw std::runtime_error("no dI_*.exr is in both " + o.dump + " and " + o.reference);
  return frames;
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
  const std::vector<std::string> frames = commonFrames(o);
  const ImageF first = readLuminance(fs::path(o.reference) / ("dI_" + frames.front()));
  const int w = first.width(), h = first.height();
  std::puts(kHeading);
  Row mean{};
  for (const std::string& frame : frames) {
    const IntensityChange x = readChange(o.dump, frame, w, h), ref = readChange(o.reference, frame, w, h);
    const Row row = toRow(frameErrors(x, ref, static_cast<float>(o.bias), o.threshold));
    print("dI_" + frame, row);
    for (std::size_t i = 0; i < row.size(); ++i) mean[i] += row[i] / static_cast<double>(frames.size());
    if (!o.picture.empty() && frame == frames.back()) writeComparison(o, x.dI, ref.dI);
  }
  print("mean", mean);
}

}  // namespace

void addCompareCommand(CLI::App& app) {
  auto o = std::make_shared<CompareOptions>();
  auto* command = app.add_subcommand(
      "compare",
      "compare two dumps: print relative L1 and MAPE of dI and dL, false and missed events per "
      "pixel and frame, and the share of pixels with any (means over the threshold phase); "
      "draw a picture");
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
