// sky.toml beside a scene.
#include "scene/sky/sky_file.h"

#include <gtest/gtest.h>

#include "scene/library/scene_format.h"
#include "scene/library/scene_library.h"
#include "scene/mitsuba_scratch.h"
#include "scene/scene_texts.h"

namespace saccade {
namespace {

class SkyFile : public testing::Test {
 protected:
  // A triangle under such a sky.
  Scene under(const std::string& sky, const std::string& file = "scenes/mine/model.obj") {
    files_.write(file, test::kTriangle);
    files_.write("scenes/mine/sky.ppm", "P3 2 1 255  255 255 255  0 0 255");
    files_.write("scenes/mine/sky.toml", sky);
    return loadSceneFile(files_.path(file), {});
  }
  std::string fault(const std::string& sky) {
    return errorOf([&] { under(sky); });
  }

  const Scratch files_;
};

TEST_F(SkyFile, TakesThePlaceOfTheDefaultLight) {
  const Scene scene = under("radiance = [0.5, 0.25, 2]\n");
  ASSERT_TRUE(scene.environment);
  EXPECT_EQ(scene.environment->radiance, (Rgb{0.5f, 0.25f, 2}));
  EXPECT_TRUE(scene.directional_lights.empty());
  EXPECT_EQ(under("radiance = 3").environment->radiance, (Rgb{3, 3, 3}));
}

TEST_F(SkyFile, MayShowAPictureAndTurnsIt) {
  const Scene scene = under("picture = 'sky.ppm'\nturn = 90");
  EXPECT_EQ(scene.environment->radiance, (Rgb{1, 1, 1}));
  ASSERT_EQ(scene.environment->picture.width, 2);
  EXPECT_EQ(scene.environment->picture.pixels[1], (Rgb{0, 0, 1}));
  expectNear(mapVector(scene.environment->to_world, {0, 0, 1}), {1, 0, 0}, 1e-9);
  expectNear(mapVector(scene.environment->to_world, {1, 0, 0}), {0, 0, -1}, 1e-9);
}

TEST_F(SkyFile, FaultsHaveAPlace) {
  expectContains(fault("colour = 1"),
                 "sky.toml:1: there is no key 'colour'; there are: radiance, picture, turn");
  for (const std::string wrong : {"-1", "nan", "'1'", "[1, 2, -3]", "[1, 2, 'x']", "1e19"})
    expectContains(fault("\nradiance = " + wrong), "sky.toml:2: radiance must be numbers within [0, 1e18]");
  expectContains(fault("radiance = [1, 2]"), "sky.toml:1: radiance is one number, or three in brackets");
  expectContains(fault("turn = 361"), "sky.toml:1: turn must be a number of degrees within [-360, 360]");
  expectContains(fault("picture = 3"), "sky.toml:1: picture is not a text in quotes");
  expectContains(fault("picture = 'none.exr'"), "sky.toml:1: ");
  expectContains(fault("picture = 'model.obj'"), "sky.toml:1: ");
  expectContains(fault("radiance = "), "sky.toml:1: ");
}

// The outline finds the same faults, and reads no picture.
TEST_F(SkyFile, IsPartOfTheOutline) {
  EXPECT_TRUE(under("radiance = 1").environment);
  EXPECT_TRUE(outlineSceneFile(files_.path("scenes/mine/model.obj"), {}).environment);
  files_.write("scenes/mine/sky.toml", "sun = 1");
  const SceneLibrary library(files_.path("scenes"));
  expectContains(library.list().at(0).unavailable, "sky.toml:1: ");
  files_.write("scenes/mine/sky.toml", "radiance = 1");
  EXPECT_EQ(library.list().at(0).unavailable, "");
}

TEST_F(SkyFile, MayNotLeadOutOfTheScenes) {
  files_.write("sky.ppm", "P3 1 1 255  1 1 1");
  EXPECT_EQ(under("picture = '../../sky.ppm'").environment->picture.width, 1);
  expectContains(errorOf([&] { SceneLibrary(files_.path("scenes")).load("mine"); }), "leads out of");
}

TEST_F(SkyFile, IsRefusedBesideASceneOfMitsuba) {
  files_.write("scenes/mine/scene.xml", test::kSensor + std::string("<shape type='cube'/></scene>"));
  files_.write("scenes/mine/sky.toml", "radiance = 1");
  expectContains(errorOf([&] { loadSceneFile(files_.path("scenes/mine/scene.xml"), {}); }),
                 "sky.toml stands beside a scene of Mitsuba");
}

}  // namespace
}  // namespace saccade
