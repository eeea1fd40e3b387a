#include "scene/default_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "scene/shape_box.h"

namespace saccade {
namespace {

constexpr double kMargin = 1.05;  // of the distance

std::array<Vec3d, 8> cornersOf(Vec3d low, Vec3d high) {
  std::array<Vec3d, 8> all;
  for (unsigned i = 0; i < 8; ++i)
    all[i] = {i & 1 ? low.x : high.x, i & 2 ? low.y : high.y, i & 4 ? low.z : high.z};
  return all;
}

void addDefaultCamera(Scene& scene) {
  scene.width = 640, scene.height = 480, scene.fov_x_deg = 45;
  ShapeBox box = boxOf(scene);
  if (box.low.x > box.high.x) box.low = box.high = {};  // without any shape
  const Vec3d low = toDouble(box.low), high = toDouble(box.high), centre = (low + high) * 0.5;
  const Vec3d forward = normalize(Vec3d{-0.5, -0.4, -1}), right = normalize(cross(forward, {0, 1, 0}));
  const Vec3d down = cross(forward, right);
  const double half_x = std::tan(scene.fov_x_deg * std::numbers::pi / 360);
  const double half_y = half_x * scene.height / scene.width;
  double distance = 0;  // from the centre, at which each corner is within the field of view
  for (const Vec3d corner : cornersOf(low, high)) {
    const Vec3d p = corner - centre;
    const double across = std::max(std::abs(dot(p, right)) / half_x, std::abs(dot(p, down)) / half_y);
    distance = std::max(distance, across - dot(p, forward));
  }
  scene.T_world_camera = {centre + scene.origin - forward * (distance * kMargin),
                          fromAxes(right, down, forward)};
  scene.unread.push_back("the file has no camera: a default one sees all of the scene");
}

void addDefaultLight(Scene& scene) {
  scene.environment = Environment{{0.5f, 0.5f, 0.5f}, {}, {}};
  scene.directional_lights.push_back({normalize(Vec3{0.5f, -1, -1}), {3, 3, 3}});
  scene.unread.push_back(
      "the file has no light: it has default ones, from all sides and from the upper left");
}

}  // namespace

bool isLit(const Scene& scene) {
  const auto emit = [](const auto& shape) { return emits(shape); };
  return scene.environment || !scene.point_lights.empty() || !scene.spot_lights.empty() ||
         !scene.directional_lights.empty() || std::ranges::any_of(scene.meshes, emit) ||
         std::ranges::any_of(scene.spheres, emit);
}

void addDefaults(Scene& scene) {
  if (scene.paths.empty()) addDefaultCamera(scene);
  if (!isLit(scene)) addDefaultLight(scene);
}

}  // namespace saccade
