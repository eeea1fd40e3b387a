// The scenes of this project.
#include <algorithm>
#include <cstdlib>

#include "scene/camera/motion.h"
#include "scene/library/scene_library.h"
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
TEST(OwnScenes, ListsOurScenes) {
  const auto entries = SceneLibrary(kScenes).list();
  std::vector<std::string> names;
  for (const SceneEntry& entry : entries) names.push_back(entry.name);
  for (const std::string name :
       {"cornell-box", "cornell-bunny", "cornell-dragon", "cornell-turntable", "textured-cornell-box"})
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
}

TEST(OwnScenes, EverySceneIsDescribedAndHasPathsThatBeginAtItsCamera) {
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

TEST(OwnScenes, CornellBoxHasItsMeasuredParts) {
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

TEST(OwnScenes, TexturedBoxHasOneTextureAndACheckerboard) {
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

TEST(OwnScenes, BunnyStandsInTheBox) {
  if (!canOpen("cornell-bunny")) GTEST_SKIP() << "glmark2-data is not installed";
  expectStandsInTheBox("cornell-bunny", "bunny", 69666);
}

TEST(OwnScenes, DragonStandsInTheBox) {
  if (!canOpen("cornell-dragon")) GTEST_SKIP() << "dragon.obj is in none of " << meshFolders();
  expectStandsInTheBox("cornell-dragon", "dragon", 100000);
}
}  // namespace
}  // namespace saccade
