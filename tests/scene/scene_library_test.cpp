#include "scene/library/scene_library.h"

#include <sys/stat.h>

#include <algorithm>
#include <cstdlib>

#include "base/text_cut.h"
#include "scene/camera/motion.h"
#include "scene/mitsuba/mitsuba_xml.h"
#include "scene/scratch.h"

namespace saccade {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

const fs::path kScenes = fs::path(SACCADE_SOURCE_DIR) / "scenes";

fs::path realScenes() {
  const char* given = std::getenv("SACCADE_REAL_SCENES");
  return given ? fs::path(given) : fs::path(SACCADE_SOURCE_DIR).parent_path() / "shared" / "scenes";
}

TEST(SceneLibrary, ListsOurFourScenes) {
  const auto entries = SceneLibrary(kScenes).list();
  std::vector<std::string> names;
  for (const SceneEntry& entry : entries) names.push_back(entry.name);
  for (const std::string name : {"cornell-box", "cornell-bunny", "cornell-dragon", "textured-cornell-box"})
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
}

TEST(SceneLibrary, EverySceneIsDescribedAndHasPathsThatBeginAtItsCamera) {
  const SceneLibrary library(kScenes);
  for (const SceneEntry& entry : library.list()) {
    EXPECT_GT(entry.description.size(), 20u) << entry.name;
    ASSERT_GE(entry.trajectories.size(), motionNames().size() + 2) << entry.name;
    if (!entry.unavailable.empty()) continue;
    const Pose camera = library.load(entry.name).T_world_camera;
    for (const std::string& name : entry.trajectories) {
      if (isMotionName(name)) continue;
      const Trajectory path = library.loadTrajectory(entry.name, name);
      expectNear(path.at(0s).position, camera.position, 1e-5);
      expectNear(rotate(path.at(0s).rotation, {0, 0, 1}), rotate(camera.rotation, {0, 0, 1}), 1e-5);
      EXPECT_NE(path.at(1s), path.at(2s));
      EXPECT_EQ(path.at(2s), path.at(3s));
    }
  }
}

TEST(SceneLibrary, CornellBoxHasItsMeasuredParts) {
  const Scene scene = SceneLibrary(kScenes).load("cornell-box");
  EXPECT_EQ(scene.name, "cornell-box");
  EXPECT_EQ(scene.meshes.size(), 8u);
  EXPECT_EQ(colorChannels(scene), 3);
  const auto light = std::find_if(scene.meshes.begin(), scene.meshes.end(),
                                  [](const Mesh& mesh) { return luminance(mesh.radiance) > 0; });
  ASSERT_NE(light, scene.meshes.end());
  const auto& p = light->positions;
  const auto& t = light->triangles[0];
  expectNear(normalize(cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]])), {0, -1, 0}, 1e-6);
}

TEST(SceneLibrary, TexturedBoxHasOneTextureAndACheckerboard) {
  const Scene scene = SceneLibrary(kScenes).load("textured-cornell-box");
  EXPECT_EQ(scene.textures.size(), 1u);
  EXPECT_EQ(scene.textures[0].width(), 512);
  EXPECT_TRUE(std::any_of(scene.materials.begin(), scene.materials.end(), [](const Material& m) {
    return m.reflectance.kind == SurfaceColor::Kind::kCheckerboard;
  }));
}

// The mesh must stand on the floor of the box, within its walls.
void expectStandsInTheBox(const std::string& scene_name, const std::string& mesh_name,
                          std::size_t triangles) {
  const Scene scene = SceneLibrary(kScenes).load(scene_name);
  const auto mesh = std::find_if(scene.meshes.begin(), scene.meshes.end(),
                                 [&](const Mesh& m) { return m.name == mesh_name; });
  ASSERT_NE(mesh, scene.meshes.end());
  EXPECT_EQ(mesh->triangles.size(), triangles);
  float lowest = 1e9f;
  for (std::size_t i = 0; i + 1 < mesh->positions.size(); ++i) {
    const Vec3 p = mesh->positions[i];
    lowest = std::min(lowest, p.y);
    ASSERT_TRUE(p.x > 0 && p.x < 5.5f && p.y < 5.4f && p.z > 0 && p.z < 5.5f);
  }
  EXPECT_NEAR(lowest, 0, 1e-3);
}

TEST(SceneLibrary, BunnyStandsInTheBox) {
  if (!fs::exists("/usr/share/glmark2/models/bunny.obj")) GTEST_SKIP() << "glmark2-data is not installed";
  expectStandsInTheBox("cornell-bunny", "bunny", 69666);
}

TEST(SceneLibrary, DragonStandsInTheBox) {
  if (!fs::exists(realScenes() / "meshes" / "dragon.obj"))
    GTEST_SKIP() << (realScenes() / "meshes" / "dragon.obj").string() << " is absent";
  expectStandsInTheBox("cornell-dragon", "dragon", 100000);
}

TEST(SceneLibrary, UnknownNamesListTheValidOnes) {
  const SceneLibrary library(kScenes);
  const std::string scene_error = errorOf([&] { library.load("../scenes/cornell-box"); });
  expectContains(scene_error, "no scene is named '../scenes/cornell-box'");
  expectContains(scene_error, "cornell-box, cornell-bunny");
  expectContains(errorOf([&] { library.loadTrajectory("cornell-box", "../arc"); }), "there are: arc, slide");
  expectContains(errorOf([] { SceneLibrary("/no/such/folder").list(); }), "not a folder");
}

TEST(SceneLibrary, ASceneWhoseMeshIsAbsentSaysSo) {
  const Scratch files;
  files.write("scenes/lonely/scene.xml", "<scene>$dragon</scene>");
  files.write("scenes/lonely/README.md", "# lonely\n\nA scene without its dragon.\n");
  const char* given = std::getenv("SACCADE_REAL_SCENES");
  const std::string before = given ? given : "";
  setenv("SACCADE_REAL_SCENES", files.path("nowhere").c_str(), 1);
  const SceneLibrary library(files.path("scenes"));
  const auto entries = library.list();
  const std::string load_error = errorOf([&] { library.load("lonely"); });
  given ? setenv("SACCADE_REAL_SCENES", before.c_str(), 1) : unsetenv("SACCADE_REAL_SCENES");
  ASSERT_EQ(entries.size(), 1u);
  EXPECT_EQ(entries[0].description, "A scene without its dragon.");
  expectContains(entries[0].unavailable, "dragon.obj is absent");
  expectContains(load_error, "dragon.obj is absent");
}

// A scene of `body` beside a folder `secret` that is not the library's.
std::string errorOfOutsider(const Scratch& files, const std::string& body) {
  files.write("secret/a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  files.write("scenes/meshes/b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  files.write(
      "scenes/mine/scene.xml",
      "<scene><sensor type='perspective'><float name='fov' value='40'/></sensor>\n" + body + "</scene>");
  return errorOf([&] { SceneLibrary(files.path("scenes")).load("mine"); });
}

TEST(SceneLibrary, AScenesFilesStayWithinTheFolderOfTheScenes) {
  const Scratch files;
  const auto mesh = [](const std::string& filename) {
    return "<shape type='obj'><string name='filename' value='" + filename + "'/></shape>";
  };
  EXPECT_EQ(errorOfOutsider(files, mesh("../meshes/b.obj")), "no error");
  for (const std::string& name : {std::string("../../secret/a.obj"), files.path("secret/a.obj")}) {
    const std::string error = errorOfOutsider(files, mesh(name));
    expectContains(error, "scene.xml:2: ");
    expectContains(error, "a.obj leads out of the folder of the scenes");
  }
  fs::create_directory_symlink(files.path("secret"), files.path("scenes/mine/models"));
  expectContains(errorOfOutsider(files, mesh("models/a.obj")), "leads out of the folder");
  EXPECT_NO_THROW(loadMitsubaXml(files.path("scenes/mine/scene.xml")));  // who opens it by hand may
  expectContains(errorOfOutsider(files,
                                 "<shape type='cube'><bsdf type='diffuse'><texture type='bitmap' "
                                 "name='reflectance'><string name='filename' value='../../secret/a.png'/>"
                                 "</texture></bsdf></shape>"),
                 "a.png leads out");
}

TEST(SceneLibrary, ALinkThatLeadsOutIsNoScene) {
  const Scratch files;
  files.write("secret/scene.xml", "<scene/>");
  files.write("scenes/README.md", "");
  fs::create_directory_symlink(files.path("secret"), files.path("scenes/linked"));
  const SceneLibrary library(files.path("scenes"));
  expectContains(errorOf([&] { library.load("linked"); }), "leads out of the folder");
  expectContains(library.list().at(0).unavailable, "leads out of the folder");
}

TEST(SceneLibrary, LinksToOtherPeoplesTextAreNotRead) {
  const Scratch files;
  const std::string secret = files.write("secret.txt", "A password.");
  files.write("scenes/mine/scene.xml", "<scene/>");
  fs::create_directory(files.path("scenes/mine/trajectories"));
  fs::create_symlink(secret, files.path("scenes/mine/README.md"));
  fs::create_symlink(secret, files.path("scenes/mine/trajectories/path.csv"));
  const SceneLibrary library(files.path("scenes"));
  EXPECT_EQ(library.list().at(0).description, "no description: " + files.path("scenes/mine/README.md") +
                                                  " leads out of the folder of the scenes");
  expectContains(errorOf([&] { library.loadTrajectory("mine", "path"); }), "leads out of the folder");
}

// Folders that hold odd things, beside one that is as it should be.
class OddFolders : public testing::Test {
 protected:
  OddFolders() { files_.write("good/scene.xml", "<scene/>"); }

  std::string at(const std::string& name) { return files_.path(name); }
  void makeFifo(const std::string& name) { ASSERT_EQ(mkfifo(at(name).c_str(), 0600), 0) << name; }
  void makeHuge(const std::string& name) {
    files_.write(name, "Much.\n");
    fs::resize_file(at(name), std::uintmax_t{2} << 30);  // a hole, that takes no place on the disk
  }
  // Lists the scenes: `name`, and the good one, which is not touched.
  SceneEntry entry(const std::string& name) {
    const auto entries = SceneLibrary(files_.path("")).list();
    EXPECT_EQ(entries.size(), name == "good" ? 1u : 2u);
    SceneEntry found;
    for (const SceneEntry& entry : entries) {
      if (entry.name == name) found = entry;
      EXPECT_TRUE(entry.name == name || entry.unavailable.empty()) << entry.unavailable;
      EXPECT_TRUE(isUtf8(entry.name) && isUtf8(entry.description) && isUtf8(entry.unavailable));
    }
    EXPECT_EQ(found.name, name);
    return found;
  }
  void expectUnavailable(const std::string& name, const std::string& why) {
    expectContains(entry(name).unavailable, why);
    if (isUtf8(name)) expectContains(errorOf([&] { SceneLibrary(files_.path("")).load(name); }), why);
    EXPECT_EQ(entry(name).trajectories, motionNames());
  }

  const Scratch files_;
};

TEST_F(OddFolders, AFifoOrAFolderIsNoSceneFile) {
  fs::create_directories(at("fifo"));
  makeFifo("fifo/scene.xml");
  expectUnavailable("fifo", "fifo/scene.xml: cannot be read: is no plain file");
  fs::remove_all(at("fifo"));
  fs::create_directories(at("folder/scene.xml"));
  expectUnavailable("folder", "folder/scene.xml: cannot be read: is no plain file");
}

TEST_F(OddFolders, LinksInCirclesAreToldBySceneAndHurtNoOther) {
  fs::create_symlink("loop", at("loop"));
  expectUnavailable("loop", "loop/scene.xml: Too many levels of symbolic links");
  fs::remove(at("loop"));
  fs::create_directories(at("scene"));
  fs::create_symlink("scene.xml", at("scene/scene.xml"));
  expectUnavailable("scene", "scene/scene.xml: Too many levels of symbolic links");
  fs::remove(at("scene/scene.xml"));
  files_.write("scene/scene.xml", "<scene/>");
  fs::create_symlink("trajectories", at("scene/trajectories"));
  expectUnavailable("scene", "scene/trajectories: is not a folder that can be read");
}

TEST_F(OddFolders, ALinkThatLeadsNowhereIsTold) {
  fs::create_directories(at("scene"));
  fs::create_symlink("nowhere", at("scene/scene.xml"));
  expectUnavailable("scene", "scene/scene.xml: cannot be read: No such file or directory");
}

TEST_F(OddFolders, AReadmeOfAnyKindLeavesItsSceneAlone) {
  makeFifo("good/README.md");
  expectContains(entry("good").description, "no description: " + at("good/README.md"));
  fs::remove(at("good/README.md"));
  fs::create_directories(at("good/README.md"));
  expectContains(entry("good").description, "no description: ");
  fs::remove(at("good/README.md"));
  fs::create_symlink("README.md", at("good/README.md"));
  expectContains(entry("good").description, "no description: ");
  fs::remove(at("good/README.md"));
  files_.write("good/README.md", "# good\n\n\xFF" + std::string(5000, 'a'));
  EXPECT_EQ(entry("good").description, "\uFFFD" + std::string(997, 'a') + "...");
}

TEST_F(OddFolders, HugeFilesAreNotReadToTheirEnds) {
  makeHuge("good/README.md");
  EXPECT_EQ(entry("good").description, "Much.");
  makeHuge("huge/scene.xml");
  expectUnavailable("huge", "huge/scene.xml: has more than 67108864 bytes");
}

TEST_F(OddFolders, ANameThatIsNoUtf8IsShownButCannotBeAsked) {
  files_.write("x\xFF/scene.xml", "<scene/>");
  expectContains(entry("x\uFFFD").unavailable, "is no UTF-8");
  files_.write("good/trajectories/\xFF.csv", "0 0 0 0 0 0 0 1");
  files_.write("good/trajectories/path.csv", "0 0 0 0 0 0 0 1");
  fs::remove_all(at("x\xFF"));
  EXPECT_EQ(entry("good").trajectories.size(), motionNames().size() + 1);
}

TEST_F(OddFolders, AFifoAsTrajectoryIsNamed) {
  fs::create_directories(at("good/trajectories"));
  makeFifo("good/trajectories/path.csv");
  expectContains(errorOf([&] { SceneLibrary(at("")).loadTrajectory("good", "path"); }),
                 "path.csv: cannot be read: is no plain file");
}

}  // namespace
}  // namespace saccade
