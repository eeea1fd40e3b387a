#include "scene/scene_origin.h"

#include <cmath>

#include "scene/mitsuba_scratch.h"
#include "scene/scene_hash.h"

namespace saccade {
namespace {

// A cube of edge 2, whose diagonal is 2 sqrt(3) = 3.46, around a place.
Scene cubeAt(Vec3d place) {
  Scene scene;
  const auto at = [](double v) { return static_cast<float>(v); };
  for (const double side : {-1., 1.})
    scene.spheres.push_back({"ball",
                             {at(place.x + side * 0.5), at(place.y + side * 0.5), at(place.z + side * 0.5)},
                             0.5f,
                             0,
                             {}});
  return scene;
}

TEST(SceneOrigin, StaysWhereTheSceneIsNear) {
  EXPECT_EQ(originOf({}), Vec3d{});
  EXPECT_EQ(originOf(cubeAt({})), Vec3d{});
  EXPECT_EQ(originOf(cubeAt({400, -400, 440})), Vec3d{});  // 128 diagonals are 443
}

// Multiples of 4, the power of two above the diagonal; each coordinate by itself.
TEST(SceneOrigin, IsTheRoundedCentreOfASceneThatIsFar) {
  EXPECT_EQ(originOf(cubeAt({449, 0, 3})), (Vec3d{448, 0, 0}));
  EXPECT_EQ(originOf(cubeAt({-1e5 - 1, 1e6, 0})), (Vec3d{-100000, 1000000, 0}));
}

TEST(SceneOrigin, CountsInDiagonalsNotInUnits) {
  Scene large = cubeAt({});
  for (Sphere& s : large.spheres) s.center = s.center * 1e6f + Vec3{5e6f, 0, 0}, s.radius *= 1e6f;
  EXPECT_EQ(originOf(large), Vec3d{});
  Scene small = cubeAt({});
  for (Sphere& s : small.spheres) s.center = s.center * 1e-3f + Vec3{1, 0, 0}, s.radius *= 1e-3f;
  EXPECT_EQ(originOf(small).x, 1);
}

std::string translated(const std::string& type, const std::string& inside, Vec3d by) {
  return "<shape type='" + type + "'>" + inside +
         "<transform name='to_world'><scale value='0.37'/><translate x='" + std::to_string(by.x) + "' y='" +
         std::to_string(by.y) + "' z='" + std::to_string(by.z) + "'/></transform></shape>";
}

Scene room(const Scratch& files, Vec3d at) {
  return loadBody(files, translated("cube", "", {at.x + 0.3, at.y, at.z}) +
                             translated("cube", "", {at.x - 1.1, at.y + 0.7, at.z}) +
                             translated("obj", "<string name='filename' value='a.obj'/>", at) +
                             translated("sphere", "<float name='radius' value='0.7'/>", at) +
                             "<emitter type='point'><point name='position' x='" + std::to_string(at.x + 0.9) +
                             "' y='" + std::to_string(at.y) + "' z='" + std::to_string(at.z) +
                             "'/><float name='intensity' value='1'/></emitter>");
}

TEST(SceneOrigin, AFarSceneIsReadAsIfItWereNear) {
  const Scratch files;
  files.write("a.obj", "v 0 0 0.1\nv 1 0 0.2\nv 0 1.3 0\nf 1 2 3\n");
  const Scene near = room(files, {});
  EXPECT_EQ(near.origin, Vec3d{});
  for (const double far : {1024., 1e4, 1e5, 1e6, -1048576.}) {
    const Vec3d at{far, 0, -far};
    const Scene moved = room(files, at);
    EXPECT_EQ(moved.origin, at);
    ASSERT_EQ(moved.meshes.size(), near.meshes.size());
    for (std::size_t m = 0; m < near.meshes.size(); ++m)
      for (std::size_t i = 0; i < near.meshes[m].positions.size(); ++i)
        expectNear(moved.meshes[m].positions[i], near.meshes[m].positions[i], 2e-7);
    expectNear(moved.spheres[0].center, near.spheres[0].center, 2e-7);
    expectNear(moved.point_lights[0].position, near.point_lights[0].position, 2e-7);
    EXPECT_NE(hashScene(moved), hashScene(near));  // poses of the one mean nothing in the other
  }
}

// The sensor is told in the world, as all poses are.
TEST(SceneOrigin, ThePoseOfTheSensorStaysInTheWorld) {
  const Scratch files;
  const Scene scene = loadMitsubaXml(files.write(
      "scene.xml",
      "<scene version='3.0.0'><sensor type='perspective'><float name='fov' value='40'/><transform "
      "name='to_world'>"
      "<translate x='1000000.25' y='2' z='3'/></transform></sensor><shape type='sphere'><point name='center' "
      "x='1000000' y='2' z='7'/></shape></scene>"));
  EXPECT_EQ(scene.T_world_camera.position, (Vec3d{1000000.25, 2, 3}));
  EXPECT_EQ(scene.origin, (Vec3d{1000000, 0, 0}));
  expectNear(scene.spheres[0].center, {0, 2, 7}, 0);
}

}  // namespace
}  // namespace saccade
