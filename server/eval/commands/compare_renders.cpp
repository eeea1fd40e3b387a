// `saccade-eval compare-renders` compares a picture with that of another program, block by block.
#include <cstdio>
#include <memory>

#include "base/number_in.h"
#include "eval/bench/arguments.h"
#include "eval/commands/commands.h"
#include "eval/metrics/picture_noise.h"
#include "eval/pictures/ratio_picture.h"
#include "eval/pictures/text.h"

namespace saccade::eval {
namespace {

struct CompareRendersOptions {
  std::string picture, reference, output;
  std::vector<std::string> left_out;
  BlockSettings blocks;
};

PixelRect parseRect(const std::string& text) {
  PixelRect r;
  int end = 0;
  if (std::sscanf(text.c_str(), "%d,%d,%dx%d%n", &r.x, &r.y, &r.width, &r.height, &end) == 4 &&
      static_cast<std::size_t>(end) == text.size() && r.width > 0 && r.height > 0)
    return r;
  throw CLI::ValidationError("--leave-out", "must be X,Y,WxH in pixels of the reference, not " + text);
}

void runCompareRenders(const CompareRendersOptions& o) {
  if (!o.output.empty()) checkOutputFile(o.output, {".svg"});
  BlockSettings settings = o.blocks;
  for (const std::string& text : o.left_out) settings.left_out.push_back(parseRect(text));
  const RgbPlanes picture = readRgb(o.picture), reference = readRgb(o.reference);
  const BlockRatios ratios = blockRatios(picture, reference, settings);
  const auto [r, g, b] = ratios.meanRatio();
  std::printf("%d of %zu blocks compared\n", ratios.compared(), ratios.blocks.size());
  std::printf("mean ratio: R %.4f  G %.4f  B %.4f\n", r, g, b);
  for (const double within : {0.05, 0.1, 0.25})
    std::printf("blocks within %2.0f %%: %.2f %%\n", 100 * within, 100 * ratios.shareWithin(within));
  if (picture[0].width() == reference[0].width())
    std::printf("relative noise: %.4g\n", relativeNoise(picture, reference));
  if (!o.output.empty()) writeText(o.output, drawRatios(picture, reference, ratios));
}

}  // namespace

void addCompareRendersCommand(CLI::App& app) {
  auto o = std::make_shared<CompareRendersOptions>();
  auto* command = app.add_subcommand(
      "compare-renders",
      "compare two pictures of one view by their means over square blocks: print the mean ratio and the "
      "share of blocks that agree, and for pictures of one size the noise of a pixel; draw a picture");
  command
      ->add_option("picture", o->picture,
                   "OpenEXR with R, G, B, as render writes it without --grey; may be smaller by a "
                   "whole factor")
      ->required()
      ->check(CLI::ExistingFile);
  command->add_option("reference", o->reference, "OpenEXR with R, G, B, linear")
      ->required()
      ->check(CLI::ExistingFile);
  command->add_option("--blocks", o->blocks.edge, "side of a block in pixels of the reference")
      ->check(NumberIn(1, 16384))
      ->capture_default_str();
  command
      ->add_option("--least-light", o->blocks.least_light,
                   "leave out blocks darker than this share of the median block")
      ->check(NumberIn(0.0, 1.0))
      ->capture_default_str();
  command->add_option("--leave-out", o->left_out,
                      "X,Y,WxH: leave out the blocks with these pixels of the reference; may be given again");
  command->add_option("-o,--output", o->output,
                      "SVG picture of both, and of the blocks that are too dark (blue) or too bright (red)");
  command->callback([o] { runCompareRenders(*o); });
}

}  // namespace saccade::eval
