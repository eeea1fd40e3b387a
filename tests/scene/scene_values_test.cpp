#include "scene/mitsuba/scene_values.h"

#include "scene/library/scene_format.h"
#include "scene/library/scene_library.h"
#include "scene/mitsuba_scratch.h"

namespace saccade {
namespace {

using namespace std::chrono_literals;

const std::string kBall = "<shape type='sphere'><float name='radius' value='$size'/></shape>";
const std::string kDefault = "<default name='size' value='2'/>";

float radiusWith(const std::string& values, const std::string& body) {
  const Scratch files;
  files.write("values.toml", values);
  return loadBody(files, body).spheres.at(0).radius;
}

TEST(SceneValues, GiveNamesTheirValues) {
  EXPECT_EQ(radiusWith("", kDefault + kBall), 2);
  EXPECT_EQ(radiusWith("size = 3", kBall), 3);
  EXPECT_EQ(radiusWith("size = 0.25", kDefault + kBall), 0.25f);
  EXPECT_EQ(radiusWith("size = '7'", kBall + kDefault), 7);
  EXPECT_EQ(radiusWith("size = 3  # not read but named", kDefault + "<shape type='sphere'/>"), 1);
  const std::string sampler =
      "<sampler type='independent'><integer name='sample_count' value='$spp'/></sampler>";
  EXPECT_EQ(radiusWith("size = 3", sampler + kBall), 3);
  EXPECT_EQ(radiusWith("size = 3\nspp = 8", sampler + kBall), 3);
  const Scratch files;
  files.write("values.toml", "flat = true\nfile = \"a.obj\"");
  files.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const Scene s = loadBody(files,
                           "<shape type='obj'><string name='filename' value='$file'/>"
                           "<boolean name='face_normals' value='$flat'/></shape>");
  EXPECT_TRUE(s.meshes.at(0).normals.empty());
}

TEST(SceneValues, FaultsNameTheLineAndWhatTheSceneHas) {
  const auto error = [](const std::string& values) {
    return errorOf([&] { radiusWith(values, kDefault + kBall); });
  };
  expectContains(error("\nsise = 3"), "values.toml:2: the scene has no $sise; it has: $size");
  expectContains(error("size = [1]"),
                 "values.toml:1: 'size' must be a text in quotes, a number, true or false");
  expectContains(error("\n\nsize = "), "values.toml:3: ");
  expectContains(error("size = 'large'"), "scene.xml:3: 'large' is not a finite number");
  expectContains(errorOf([] { radiusWith("size = 1", kBall + "<bsdf type='$kind'/>"); }),
                 "scene.xml:3: $kind is not defined; defined: $size. A <default> or values.toml");
}

TEST(SceneValues, AreRefusedBesideASceneWithoutNames) {
  const Scratch files;
  files.write("values.toml", "size = 3");
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const std::string scene = files.write("model.obj", triangle), other = files.write("other.obj", triangle);
  expectContains(errorOf([&] { loadSceneFile(scene, {}); }),
                 "values.toml stands beside a scene of OBJ, which has no $names");
  EXPECT_EQ(loadSceneFile(other, {}).meshes.size(), 1);  // the values are those of a scene beside it
}

TEST(SceneValues, AChangeOfThemIsAChangeOfTheScene) {
  const Scratch files;
  const std::string sensor = "<scene><sensor type='perspective'/>";
  files.write("all/mine/scene.xml", sensor + kBall + "</scene>");
  const SceneLibrary library(files.path("all"));
  expectContains(library.list().at(0).unavailable, "$size is not defined");
  const auto before = library.lastChange("mine");
  const std::string values = files.write("all/mine/values.toml", "size = 5");
  std::filesystem::last_write_time(values, before + 1s);
  EXPECT_EQ(library.lastChange("mine"), before + 1s);
  EXPECT_EQ(library.list().at(0).unavailable, "");
  EXPECT_EQ(library.load("mine").spheres.at(0).radius, 5);
  files.write("all/mine/values.toml", "size = ");
  std::filesystem::last_write_time(values, before + 2s);
  expectContains(library.list().at(0).unavailable, "values.toml:1: ");
}

}  // namespace
}  // namespace saccade
