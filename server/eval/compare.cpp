// `saccade-eval compare`: dumped frames against those of the reference, in figures and as a picture.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "eval/commands.h"
#include "eval/exr.h"
#include "eval/metrics.h"

namespace saccade {
namespace {

struct CompareOptions {
  std::string dump, reference, picture;
};

// Blue below, white at, red above zero; `scale` is full colour.
Rgb8 divergingColor(float v, float scale) {
  const float s = std::clamp(v / scale, -1.f, 1.f), rest = 255 * (1 - std::abs(s));
  const auto fade = static_cast<unsigned char>(rest);
  return s > 0 ? Rgb8{255, fade, fade} : Rgb8{fade, fade, 255};
}

// The 99th percentile of |v|: a few edges must not take all the colour.
float colorScale(const ImageF& plane) {
  std::vector<float> values;
  for (int y = 0; y < plane.height(); ++y) {
    for (int x = 0; x < plane.width(); ++x) values.push_back(std::abs(plane.at(x, y)));
  }
  const auto rank = static_cast<std::ptrdiff_t>(0.97 * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return std::max(values[static_cast<std::size_t>(rank)], 1e-9f);
}

// Ours, reference and their difference side by side, all in the reference's scale.
void writeComparison(const std::string& path, const ImageF& x, const ImageF& ref) {
  const int w = ref.width(), h = ref.height();
  const float scale = colorScale(ref);
  std::vector<Rgb8> pixels;
  pixels.reserve(static_cast<std::size_t>(3 * w) * h);
  for (int row = 0; row < h; ++row) {
    for (int column = 0; column < 3 * w; ++column) {
      const int c = column % w;
      const float v[3] = {x.at(c, row), ref.at(c, row), x.at(c, row) - ref.at(c, row)};
      pixels.push_back(divergingColor(v[column / w], scale));
    }
  }
  writePng(path, 3 * w, h, pixels);
}

void runCompare(const CompareOptions& o) {
  int compared = 0;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(o.dump)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const auto& file : files) {
    const std::string name = file.filename().string();
    const auto truth = std::filesystem::path(o.reference) / name;
    if (!name.starts_with("dI_") || !std::filesystem::exists(truth)) continue;
    const ExrPicture x = readExr(file.string()), ref = readExr(truth.string());
    std::printf("%s  relative L1 %.4f\n", name.c_str(), relativeL1(x.planes.at("Y"), ref.planes.at("Y")));
    if (!o.picture.empty()) writeComparison(o.picture, x.planes.at("Y"), ref.planes.at("Y"));
    ++compared;
  }
  if (compared == 0) throw std::runtime_error("no dI_*.exr stands in both " + o.dump + " and " + o.reference);
}

}  // namespace

void addCompareCommand(CLI::App& app) {
  auto o = std::make_shared<CompareOptions>();
  auto* command = app.add_subcommand("compare", "dI of two dumps: relative L1 of each frame, and a picture");
  command->add_option("dump", o->dump, "folder written by frames --dump")
      ->required()
      ->check(CLI::ExistingDirectory);
  command->add_option("reference", o->reference, "folder written by frames --reference --dump")
      ->required()
      ->check(CLI::ExistingDirectory);
  command->add_option("-o,--output", o->picture, "PNG of the last frame: dump, reference, their difference");
  command->callback([o] { runCompare(*o); });
}

}  // namespace saccade
