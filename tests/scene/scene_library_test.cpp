#include "scene/library/scene_library.h"

#include <algorithm>

#include "scene/scene_texts.h"
#include "scene/scratch.h"

namespace saccade {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using test::kSensor, test::kTriangle;

const fs::path kScenes = fs::path(SACCADE_SOURCE_DIR) / "scenes";

TEST(SceneLibrary, UnknownNamesListTheValidOnes) {
  const SceneLibrary library(kScenes);
  const std::string scene_error = errorOf([&] { library.load("../scenes/cornell-box"); });
  expectContains(scene_error, "../scenes/cornell-box");
  expectContains(scene_error, "cornell-box, cornell-bunny");
  expectContains(errorOf([&] { library.loadTrajectory("cornell-box", "../arc"); }), "there are: arc, slide");
  expectContains(errorOf([] { SceneLibrary("/no/such/folder").list(); }), "not a folder");
}

TEST(SceneLibrary, NoNameLeadsOutOfTheFolder) {
  const SceneLibrary library(kScenes / "cornell-box");
  for (const std::string name : {"..", ".", "", "../cornell-box", "/", "a/../../cornell-box"})
    EXPECT_FALSE(library.find(name)) << name;
}

TEST(SceneLibrary, AFileInPlaceOfANameIsToldAsThat) {
  const SceneLibrary library(kScenes);
  expectContains(library.unknown("my.fbx"),
                 "my.fbx is not a scene of Mitsuba, glTF, binary glTF, OBJ, PLY; read are .xml, .gltf, .glb, "
                 ".obj, .ply; there are: ");
  expectContains(library.unknown("my.obj"), "my.obj is a file; give the name of a scene");
  expectContains(library.unknown("my.blend"), ".ply; Blender exports glTF; there are: ");
  expectContains(library.unknown("mine/scene.xml"), "mine/scene.xml is a file; give the name of a scene");
  expectContains(library.unknown("mine"), "no scene is named 'mine'; there are: ");
}
std::string withMesh(const std::string& filename) {
  return kSensor + ("\n<shape type='obj'><string name='filename' value='" + filename + "'/></shape></scene>");
}

TEST(SceneLibrary, ASceneWhoseMeshIsAbsentSaysSo) {
  const Scratch files;
  files.write("scenes/lonely/scene.xml", withMesh("bunny.obj"));
  files.write("scenes/lonely/README.md", "# lonely\n\nA scene without its bunny.\n");
  files.write("meshes/bunny2.obj", kTriangle);
  const SceneLibrary library(files.path("scenes"), files.path("meshes"));
  const auto entries = library.list();
  ASSERT_EQ(entries.size(), 1u);
  EXPECT_EQ(entries[0].description, "A scene without its bunny.");
  for (const std::string& why : {entries[0].unavailable, errorOf([&] { library.load("lonely"); })}) {
    expectContains(why, "scene.xml:2: ");
    expectContains(why,
                   "bunny.obj is absent, and no folder of <path>, --meshes or SACCADE_MESHES holds it: " +
                       files.path("meshes"));
  }
}

TEST(SceneLibrary, ThePackageIsNamedForTheMeshThatItHolds) {
  const Scratch files;
  files.write("scenes/lonely/scene.xml", withMesh("no such mesh.obj"));
  const std::string error = errorOf([&] { SceneLibrary(files.path("scenes")).load("lonely"); });
  expectContains(error, "SACCADE_MESHES holds it: /usr/share/glmark2/models");
  EXPECT_EQ(error.find("glmark2-data"), std::string::npos) << error;
  EXPECT_EQ(describeFolders({kDefaultMeshes}, "bunny.obj"),
            "/usr/share/glmark2/models (install the Debian package glmark2-data)");
}

TEST(SceneLibrary, AMeshComesFromBesideTheSceneOrTheFirstFolderThatHoldsIt) {
  const Scratch files;
  const auto triangles = [&](int count) {
    std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (int i = 0; i < count; ++i) obj += "f 1 2 3\n";
    return obj;
  };
  files.write("scenes/mine/scene.xml", withMesh("a.obj"));
  files.write("second/a.obj", triangles(3));
  const SceneLibrary library(files.path("scenes"), files.path("first") + ":" + files.path("second"));
  const auto loaded = [&] { return library.load("mine").meshes.at(0).triangles.size(); };
  EXPECT_EQ(loaded(), 3u);
  files.write("first/a.obj", triangles(2));
  EXPECT_EQ(loaded(), 2u);
  files.write("scenes/mine/a.obj", triangles(1));
  EXPECT_EQ(loaded(), 1u);
}

TEST(SceneLibrary, TheIndexFollowsChangesOfAScene) {
  const Scratch files;
  files.write("scenes/mine/scene.xml", withMesh("a.obj"));
  const SceneLibrary library(files.path("scenes"), files.path("meshes"));
  expectContains(library.list().at(0).unavailable, "a.obj is absent");
  files.write("meshes/a.obj", kTriangle);  // no file of the scene has changed
  EXPECT_EQ(library.list().at(0).unavailable, "");
  files.write("scenes/mine/README.md", "A triangle.\n");
  EXPECT_EQ(library.list().at(0).description, "A triangle.");
  files.write("scenes/mine/trajectories/path.csv", "0 0 0 0 0 0 0 1");
  EXPECT_EQ(library.list().at(0).trajectories.at(0), "path");
  EXPECT_EQ(library.find("mine")->trajectories.at(0), "path");
  const std::string file = files.write("scenes/mine/scene.xml", "<scene>");
  fs::last_write_time(file, fs::last_write_time(file) + 1s);
  expectContains(library.list().at(0).unavailable, "faulty XML");
  fs::remove_all(files.path("scenes/mine"));
  EXPECT_TRUE(library.list().empty());
}

// An unchanged file is not read again: it keeps its entry while its time stays as it was.
TEST(SceneLibrary, TheIndexReadsOnlyWhatHasChanged) {
  const Scratch files;
  files.write("scenes/mine/scene.xml", std::string(kSensor) + "</scene>");
  const std::string readme = files.write("scenes/mine/README.md", "Before.\n");
  const SceneLibrary library(files.path("scenes"));
  EXPECT_EQ(library.list().at(0).description, "Before.");
  const auto time = fs::last_write_time(readme);
  files.write("scenes/mine/README.md", "After.\n");
  fs::last_write_time(readme, time);
  EXPECT_EQ(library.list().at(0).description, "Before.");
}
}  // namespace
}  // namespace saccade
