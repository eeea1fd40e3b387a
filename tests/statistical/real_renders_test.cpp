// Compares other people's scenes with their authors' renders: linear, at the depth that each file says, means
// over blocks of 16x16 pixels or more. Their pixel filter differs from ours only at the edges of lamps, which
// are left out.
//
// Quick by default. SACCADE_FULL=1 takes more paths and bounces; $SACCADE_OUT is a folder for pictures of
// both side by side, with a map of their ratio.
#include <gtest/gtest.h>

#include "eval/pictures/ratio_picture.h"
#include "eval/pictures/text.h"
#include "render/renderer.h"
#include "scene/mitsuba/mitsuba_xml.h"
#include "statistical/outside_files.h"

namespace saccade::eval {
namespace {

const bool kFull = std::getenv("SACCADE_FULL") != nullptr;

struct Effort {
  int spp, bounces;
  int shrink = 1;  // the picture's size by this
};

RgbPlanes render(const std::string& file, Effort effort) {
  const auto scene = std::make_shared<RenderScene>(loadMitsubaXml(file));
  const Scene& s = scene->description();
  const int w = s.width / effort.shrink, h = s.height / effort.shrink;
  TilePool pool(2);
  const PosedScene posed(scene);
  const Camera camera(s.T_world_camera, pinhole(s.fov_x_deg, w, h));
  Renderer renderer({effort.bounces, 3});
  Frame frame(w, h);
  ImageF rgb[3] = {{w, h}, {w, h}, {w, h}};
  renderer.renderStill(PixelContext({posed, camera}), SeedPlan::independent(1, 0, effort.spp), pool, frame,
                       rgb);
  return {std::move(rgb[0]), std::move(rgb[1]), std::move(rgb[2])};
}

// Prints what was found.
BlockRatios compare(const std::string& folder, const std::string& file, Effort effort,
                    const BlockSettings& settings) {
  const RgbPlanes picture = render(test::realScene(folder + file), effort);
  const RgbPlanes reference = readRgb(test::realScene(folder + "TungstenRender.exr"));
  BlockRatios ratios = blockRatios(picture, reference, settings);
  const auto [r, g, b] = ratios.meanRatio();
  std::printf("%d spp, %d bounces: mean ratio %.4f %.4f %.4f, %.2f %% of %d blocks within 10 %%\n",
              effort.spp, effort.bounces, r, g, b, 100 * ratios.shareWithin(0.1), ratios.compared());
  if (const char* out = std::getenv("SACCADE_OUT"))
    writeText(std::string(out) + "/" + folder.substr(0, folder.size() - 1) + "_ratio.svg",
              drawRatios(picture, reference, ratios));
  return ratios;
}

TEST(RealRenders, CornellBox) {
  SACCADE_NEEDS(test::realScene("cornell-box/scene.xml"));
  const PixelRect lamp{400, 64, 224, 48};
  const BlockRatios ratios =
      compare("cornell-box/", "scene.xml", kFull ? Effort{32, 64} : Effort{2, 24}, {.left_out = {lamp}});
  for (const double ratio : ratios.meanRatio()) EXPECT_NEAR(ratio, 1, 0.005);
  EXPECT_GE(ratios.shareWithin(0.1), kFull ? 0.99 : 0.9);
}

void expectLikeTheAuthors(const BlockRatios& ratios) {
  for (const double ratio : ratios.meanRatio()) EXPECT_NEAR(ratio, 1, kFull ? 0.03 : 0.05);
  EXPECT_GE(ratios.shareWithin(0.1), kFull ? 0.9 : 0.3);
}

// Blocks that differ: gold and brushed metal on the table, and two treads seen at a grazing angle.
TEST(RealRenders, Staircase) {
  SACCADE_NEEDS(test::realScene("staircase/scene.xml"));
  expectLikeTheAuthors(compare("staircase/", "scene.xml", kFull ? Effort{16, 24} : Effort{2, 12, 2}, {}));
}

// Six meshes are absent: two fields of tiles, parts of the cooker, of the kettle and of the microwave.
// Of the rest the blinds differ (half as bright here): two sheets 0.3 mm apart, of which the author's program
// may see one alone.
TEST(RealRenders, Kitchen) {
  SACCADE_NEEDS(test::realScene("kitchen/scene-289.xml"));
  SACCADE_NEEDS(test::realScene("kitchen/models"));
  const BlockSettings settings{.left_out = {{0, 352, 208, 208},    // tiles, one of Mesh054 and Mesh145
                                            {384, 352, 256, 112},  // the other; microwave, Mesh294
                                            {224, 464, 304, 256},  // cooker, Mesh090
                                            {368, 400, 64, 80}}};  // kettle, Mesh273 and Mesh275
  expectLikeTheAuthors(
      compare("kitchen/", "scene-289.xml", kFull ? Effort{16, 15} : Effort{2, 12, 2}, settings));
}

// The closed room gains light with every bounce. The glass teapot is up to 1.6 times as bright here. The file
// says nothing of what its glass absorbs, and the author's program may know it.
TEST(RealRenders, VeachAjar) {
  SACCADE_NEEDS(test::realScene("veach-ajar/scene.xml"));
  const BlockSettings settings{.edge = 64, .left_out = {{640, 384, 192, 128}}};
  expectLikeTheAuthors(compare("veach-ajar/", "scene.xml", Effort{kFull ? 128 : 8, 11, 4}, settings));
}

}  // namespace
}  // namespace saccade::eval
