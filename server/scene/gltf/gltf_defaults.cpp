#include "scene/gltf/gltf_defaults.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/motion/shape_box.h"

namespace saccade {
namespace {

constexpr Vec3d kFromCentre{0.5, 0.4, 1};  // to the camera
constexpr double kRoom = 1.1;              // around the scene, in the picture

bool isLit(const Scene& scene) {
  return scene.environment || !scene.point_lights.empty() || !scene.spot_lights.empty() ||
         !scene.directional_lights.empty() ||
         std::ranges::any_of(scene.meshes, [](const Mesh& mesh) { return emits(mesh); });
}

void addCamera(Scene& scene) {
  const ShapeBox box = boxOf(scene);
  const double radius = std::max(1e-6, length(toDouble(box.high - box.low)) / 2);
  const Vec3d back = normalize(kFromCentre), x = normalize(cross(Vec3d{0, 1, 0}, back));
  scene.width = 640, scene.height = 480;
  const double half =
      std::atan(std::tan(scene.fov_x_deg * std::numbers::pi / 360) * scene.height / scene.width);
  const Vec3d centre = toDouble(box.centre()) + scene.origin;
  scene.T_world_camera = {centre + back * (kRoom * radius / std::sin(half)),
                          fromAxes(x, -cross(back, x), -back)};
  scene.unread.push_back("the file has no perspective camera; one sees the whole scene from its front");
}

}  // namespace

void addDefaults(Scene& scene) {
  if (scene.paths.empty()) addCamera(scene);
  if (isLit(scene)) return;
  scene.environment = Environment{{1, 1, 1}, {}, {}};
  scene.unread.push_back("the file has no light; an even sky of radiance 1 lights it");
}

}  // namespace saccade
