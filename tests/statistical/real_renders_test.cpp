// Other people's scenes against their authors' own renders: linear, 65 bounces, means over blocks of 16x16
// pixels. What they render with another pixel filter differs at the edges of lamps alone, so these are left
// out.
//
// Quick by default. SACCADE_FULL=1 takes more paths and bounces; $SACCADE_OUT is a folder for pictures of
// both side by side, with a map of their ratio.
#include <gtest/gtest.h>

#include "eval/ratio_picture.h"
#include "render/renderer.h"
#include "scene/mitsuba_xml.h"
#include "statistical/outside_files.h"

namespace saccade {
namespace {

const bool kFull = std::getenv("SACCADE_FULL") != nullptr;

struct Effort {
  int spp, bounces;
};

RgbPlanes render(const std::string& file, Effort effort) {
  const auto scene = std::make_shared<RenderScene>(loadMitsubaXml(file));
  const Scene& s = scene->description();
  TilePool pool(2);
  Renderer renderer(scene, {effort.bounces, 3}, pool);
  Frame frame(s.width, s.height);
  ImageF rgb[3] = {{s.width, s.height}, {s.width, s.height}, {s.width, s.height}};
  renderer.renderStill(Camera(s.T_world_camera, s.fov_x_deg, s.width, s.height), 1, effort.spp, frame, rgb);
  return {std::move(rgb[0]), std::move(rgb[1]), std::move(rgb[2])};
}

// Compares at the reference's own size; prints what was found.
BlockRatios compare(const std::string& folder, const std::string& file, Effort effort,
                    const BlockSettings& settings) {
  const RgbPlanes picture = render(test::realScene(folder + file), effort);
  const RgbPlanes reference = readRgb(test::realScene(folder + "TungstenRender.exr"));
  BlockRatios ratios = blockRatios(picture, reference, settings);
  const auto [r, g, b] = ratios.meanRatio();
  std::printf("%d spp, %d bounces: mean ratio %.4f %.4f %.4f, %.2f %% of %d blocks within 10 %%\n",
              effort.spp, effort.bounces, r, g, b, 100 * ratios.shareWithin(0.1), ratios.compared());
  if (const char* out = std::getenv("SACCADE_OUT"))
    writePng(std::string(out) + "/" + folder + "ratio.png", 3 * reference[0].width(), reference[0].height(),
             ratioPicture(picture, reference, ratios));
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

}  // namespace
}  // namespace saccade
