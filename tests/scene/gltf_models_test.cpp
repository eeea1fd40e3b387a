// glTF files of other people and of Blender, which stand beside the project: see statistical/outside_files.h.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/gltf/gltf.h"
#include "scene/motion/bodies.h"
#include "scene/motion/own_motions.h"
#include "scene/scratch.h"
#include "statistical/outside_files.h"

namespace saccade {
namespace {

using namespace std::chrono_literals;

std::size_t triangles(const Scene& scene) {
  std::size_t count = 0;
  for (const Mesh& mesh : scene.meshes) count += mesh.triangles.size();
  return count;
}

std::vector<std::string> movers(const Scene& scene) {
  std::vector<std::string> names;
  for (const OwnMotion& motion : scene.motions) names.push_back(motion.name);
  return names;
}

// The truck's wheels turn once in 1.25 s.
TEST(GltfModels, CesiumMilkTruck) {
  for (const std::string form : {"glTF/CesiumMilkTruck.gltf", "glTF-Binary/CesiumMilkTruck.glb"}) {
    const std::string file = test::realScene("gltf/CesiumMilkTruck/" + form);
    SACCADE_NEEDS(file);
    Scene scene = loadGltf(file, {});
    EXPECT_EQ(scene.meshes.size(), 5u);
    EXPECT_EQ(triangles(scene), 3624u);
    ASSERT_EQ(movers(scene), (std::vector<std::string>{"Wheels", "Wheels@2"}));
    setBodies(scene, std::array{std::string("Wheels")});
    const Trajectory path = makeOwnMotion(scene.motions[0], scene, scene.bodies[0]);
    const Vec3d axle = path.at(0s).position;
    for (const TimeNs t : {100ms, 625ms, 1000ms, 100'000ms})
      EXPECT_LT(length(path.at(t).position - axle), 1e-3) << seconds(t);  // it turns about its middle
    const auto turned = [&](TimeNs t) {
      return length(rotationVector(conjugate(path.at(0s).rotation) * path.at(t).rotation));
    };
    EXPECT_NEAR(turned(250ms), 2 * std::numbers::pi / 5, 0.05);
    EXPECT_NEAR(turned(625ms), std::numbers::pi, 0.1);
    EXPECT_NEAR(turned(1250ms), 0.177, 1e-3);  // its last key is 10 degrees before a whole turn
    EXPECT_EQ(path.at(9s), path.at(1250ms));
  }
}

TEST(GltfModels, AnimatedCube) {
  const std::string file = test::realScene("gltf/AnimatedCube/glTF/AnimatedCube.gltf");
  SACCADE_NEEDS(file);
  const Scene scene = loadGltf(file, {});
  EXPECT_EQ(triangles(scene), 12u);
  EXPECT_EQ(movers(scene), std::vector<std::string>{"AnimatedCube"});
  EXPECT_EQ(scene.textures.size(), 2u);
}

TEST(GltfModels, BoxAnimated) {
  for (const std::string form : {"glTF/BoxAnimated.gltf", "glTF-Binary/BoxAnimated.glb"}) {
    const std::string file = test::realScene("gltf/BoxAnimated/" + form);
    SACCADE_NEEDS(file);
    const Scene scene = loadGltf(file, {});
    EXPECT_EQ(scene.meshes.size(), 2u);
    EXPECT_EQ(movers(scene), std::vector<std::string>{"inner_box"});
  }
}

TEST(GltfModels, Cameras) {
  const std::string file = test::realScene("gltf/Cameras/glTF/Cameras.gltf");
  SACCADE_NEEDS(file);
  const Scene scene = loadGltf(file, {});
  EXPECT_NEAR(scene.fov_x_deg, 0.7 * 180 / std::numbers::pi, 1e-9);
  EXPECT_EQ(scene.paths.size(), 1u);  // the other is orthographic
}

// A scene that Blender 3.4 made: a camera and a cube that move, lamps of 50, 60 W and 2 W/m2, an emissive
// quad.
TEST(GltfModels, OfBlender) {
  for (const std::string form : {"gltf", "glb"}) {
    const std::string file = test::realScene("gltf/blender-export/blender-export." + form);
    SACCADE_NEEDS(file);
    const Scene scene = loadGltf(file, {});
    EXPECT_NEAR(scene.fov_x_deg, 50, 1e-4);
    EXPECT_NEAR(scene.point_lights.at(0).intensity.x, 50 / (4 * std::numbers::pi), 1e-4);
    EXPECT_NEAR(scene.spot_lights.at(0).intensity.x, 60 / (4 * std::numbers::pi), 1e-4);
    EXPECT_NEAR(scene.directional_lights.at(0).irradiance.x, 2, 1e-4);
    const auto lamp = std::ranges::find(scene.meshes, "Lamp", &Mesh::name);
    ASSERT_NE(lamp, scene.meshes.end());
    expectNear(lamp->radiance, {17, 12, 4}, 1e-4);
    EXPECT_EQ(movers(scene), std::vector<std::string>{"Mover"});
    EXPECT_EQ(movers(outlineGltf(file, {})), std::vector<std::string>{"Mover"});
    ASSERT_EQ(scene.paths.size(), 1u);
    EXPECT_EQ(scene.paths[0].name, "Cam");
    const Trajectory& camera = scene.paths[0].path;
    EXPECT_LT(length(camera.at(0s).position - Vec3d{0, 2, 5}), 1e-4);  // Blender's (0, -5, 2)
    EXPECT_LT(length(camera.at(2s).position - Vec3d{0.5, 2, 5}), 1e-4);
  }
}

}  // namespace
}  // namespace saccade
