// Scenes of other people, which stand beside the project: see statistical/outside_files.h.
#include <algorithm>

#include "scene/mesh/mesh_io.h"
#include "scene/mitsuba/mitsuba_xml.h"
#include "scene/scratch.h"
#include "statistical/outside_files.h"

namespace saccade {
namespace {

std::size_t triangles(const Scene& scene) {
  std::size_t count = 0;
  for (const Mesh& mesh : scene.meshes) count += mesh.triangles.size();
  return count;
}

const Material& material(const Scene& scene, const std::string& name) {
  const auto found = std::find_if(scene.materials.begin(), scene.materials.end(),
                                  [&](const Material& m) { return m.name == name; });
  if (found == scene.materials.end()) throw SceneError("no material " + name);
  return *found;
}

bool isLit(const Mesh& mesh) {
  return luminance(mesh.radiance) > 0;
}

TEST(RealScenes, CornellBox) {
  const std::string file = test::realScene("cornell-box/scene.xml");
  SACCADE_NEEDS(file);
  const Scene scene = loadMitsubaXml(file);
  EXPECT_EQ(scene.meshes.size(), 8u);
  EXPECT_EQ(triangles(scene), 36u);
  EXPECT_EQ(scene.width, 1024);
  EXPECT_DOUBLE_EQ(scene.fov_x_deg, 19.5);
  expectNear(scene.T_world_camera.position, {0, 1, 6.8}, 1e-9);
  expectNear(rotate(scene.T_world_camera.rotation, {1, 0, 0}), {1, 0, 0}, 1e-9);
  expectNear(scene.meshes.back().radiance, {17, 12, 4}, 0);
}

TEST(RealScenes, VeachAjar) {
  const std::string file = test::realScene("veach-ajar/scene.xml");
  SACCADE_NEEDS(file);
  const Scene scene = loadMitsubaXml(file);
  EXPECT_EQ(scene.meshes.size(), 22u);
  EXPECT_EQ(scene.textures.size(), 3u);
  const Material& floor = material(scene, "Floor");
  EXPECT_EQ(floor.model.kind, BsdfKind::kRoughConductor);
  EXPECT_EQ(floor.specular.kind, SurfaceColor::Kind::kCheckerboard);
  EXPECT_FLOAT_EQ(floor.specular.uv_scale.x, 20);
  EXPECT_FLOAT_EQ(floor.specular.uv_scale.y, 80);
  EXPECT_EQ(material(scene, "DoorHandle").model.microfacets, MicrofacetKind::kBeckmann);
  EXPECT_EQ(std::count_if(scene.meshes.begin(), scene.meshes.end(), isLit), 1);
}

// The binary PLY form of meshes whose OBJ form is there as well.
TEST(RealScenes, VeachAjarIsTheSameAsPly) {
  const std::string obj = test::realScene("veach-ajar/models/Mesh015.obj");
  const std::string ply = test::realScene("veach-ajar/pbrt/models/Mesh015.ply");
  SACCADE_NEEDS(obj);
  SACCADE_NEEDS(ply);
  const Mesh a = loadObj(obj), b = loadPly(ply);
  ASSERT_EQ(a.triangles.size(), b.triangles.size());
  for (std::size_t i = 0; i < a.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      expectNear(a.positions[a.triangles[i][k]], b.positions[b.triangles[i][k]], 2e-6);
      expectNear(a.normals[a.triangles[i][k]], b.normals[b.triangles[i][k]], 2e-4);
    }
  }
}

TEST(RealScenes, Staircase) {
  const std::string file = test::realScene("staircase/scene.xml");
  SACCADE_NEEDS(file);
  const Scene scene = loadMitsubaXml(file);
  EXPECT_EQ(scene.meshes.size(), 775u);  // 774 OBJ files and the rectangle of the lamp
  EXPECT_EQ(triangles(scene), 262663u);
  EXPECT_EQ(scene.textures.size(), 10u);
  EXPECT_EQ(scene.width, 720);
  EXPECT_EQ(scene.height, 1280);
  EXPECT_DOUBLE_EQ(scene.fov_x_deg, 35);
  const Material& paint = material(scene, "MagnoliaPaint");
  EXPECT_EQ(paint.model.kind, BsdfKind::kRoughPlastic);
  EXPECT_TRUE(paint.model.nonlinear);
  EXPECT_TRUE(isBumpy(material(scene, "BrushedAluminium")));
  EXPECT_EQ(material(scene, "Glass").model.kind, BsdfKind::kDielectric);
}

// Its meshes are to be unpacked first.
TEST(RealScenes, Kitchen) {
  const std::string file = test::realScene("kitchen/scene-289.xml");
  SACCADE_NEEDS(file);
  SACCADE_NEEDS(test::realScene("kitchen/models"));
  const Scene scene = loadMitsubaXml(file);
  EXPECT_EQ(scene.meshes.size(), 293u);  // 289 OBJ files and the rectangles of four lamps
  EXPECT_EQ(triangles(scene), 1050933u + 8);
  EXPECT_EQ(std::count_if(scene.meshes.begin(), scene.meshes.end(), isLit), 4);
  EXPECT_EQ(material(scene, "RadioGlass").model.kind, BsdfKind::kThinDielectric);
  EXPECT_FALSE(isOpaque(material(scene, "Blinds")));
  EXPECT_TRUE(isBumpy(material(scene, "Cushion1")));
  expectContains(errorOf([&] { loadMitsubaXml(test::realScene("kitchen/scene.xml")); }),
                 "Mesh145.obj: cannot be read");
}

TEST(RealScenes, MeshesAlone) {
  struct File {
    const char* name;
    std::size_t triangles;
  };
  for (const File& f : {File{"meshes/bunny.ply", 69451}, File{"meshes/dragon.obj", 100000},
                        File{"meshes/teapot.ply", 2256}}) {
    const std::string path = test::realScene(f.name);
    SACCADE_NEEDS(path);
    const Mesh mesh = path.ends_with(".obj") ? loadObj(path) : loadPly(path);
    EXPECT_EQ(mesh.triangles.size(), f.triangles);
    EXPECT_TRUE(mesh.normals.empty());
  }
  const std::string box = test::realScene("cornell-box-original/CornellBox-Original.obj");
  SACCADE_NEEDS(box);
  EXPECT_EQ(loadObj(box).triangles.size(), 36u);  // 18 quads, of negative indices
}

}  // namespace
}  // namespace saccade
