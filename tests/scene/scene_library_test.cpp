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

// Meshes that our scenes name: the folder of the Debian package glmark2-data, and one of the tests' own
// files.
std::string meshFolders() {
  const char* given = std::getenv("SACCADE_REAL_SCENES");
  const fs::path real =
      given ? fs::path(given) : fs::path(SACCADE_SOURCE_DIR).parent_path() / "shared/scenes";
  return std::string(kDefaultMeshes) + ":" + (real / "meshes").string();
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
  const Scene scene = SceneLibrary(kScenes, meshFolders()).load(scene_name);
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

bool canOpen(const std::string& name) {
  for (const SceneEntry& entry : SceneLibrary(kScenes, meshFolders()).list())
    if (entry.name == name) return entry.unavailable.empty();
  return false;
}

TEST(SceneLibrary, BunnyStandsInTheBox) {
  if (!canOpen("cornell-bunny")) GTEST_SKIP() << "glmark2-data is not installed";
  expectStandsInTheBox("cornell-bunny", "bunny", 69666);
}

TEST(SceneLibrary, DragonStandsInTheBox) {
  if (!canOpen("cornell-dragon")) GTEST_SKIP() << "dragon.obj is in none of " << meshFolders();
  expectStandsInTheBox("cornell-dragon", "dragon", 100000);
}

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
  expectContains(library.unknown("my.gltf"), "my.gltf is no Mitsuba scene; only .xml is read; there are: ");
  expectContains(library.unknown("mine/scene.xml"), "mine/scene.xml is a file; give the name of a scene");
  expectContains(library.unknown("mine"), "no scene is named 'mine'; there are: ");
}

constexpr const char* kSensor = "<scene><sensor type='perspective'><float name='fov' value='40'/></sensor>";
constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

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
    expectContains(why, "bunny.obj is absent, and no folder of --meshes or SACCADE_MESHES holds it: " +
                            files.path("meshes"));
  }
}

TEST(SceneLibrary, TheDefaultFolderOfMeshesIsToldWithItsPackage) {
  const Scratch files;
  files.write("scenes/lonely/scene.xml", withMesh("no such mesh.obj"));
  expectContains(errorOf([&] { SceneLibrary(files.path("scenes")).load("lonely"); }),
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

// What has not changed is not read again: a file whose time stays as it was keeps its entry.
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

// A scene of `body` beside a folder `secret` that is not the library's.
std::string errorOfOutsider(const Scratch& files, const std::string& body) {
  files.write("secret/a.obj", kTriangle);
  files.write("scenes/meshes/b.obj", kTriangle);
  files.write("scenes/mine/scene.xml", kSensor + ("\n" + body) + "</scene>");
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
  EXPECT_NO_THROW(loadMitsubaXml(files.path("scenes/mine/scene.xml")));  // nothing confines it by hand
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
  OddFolders() { files_.write("good/scene.xml", kGood); }

  const std::string kGood = std::string(kSensor) + "</scene>";

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
  files_.write("scene/scene.xml", kGood);
  fs::create_symlink("trajectories", at("scene/trajectories"));
  expectContains(entry("scene").unavailable, "scene/trajectories: is not a folder that can be read");
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
  expectContains(entry("x\uFFFD").unavailable, "is not UTF-8");
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
