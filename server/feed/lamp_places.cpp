#include "feed/lamp_places.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/shape_box.h"

namespace saccade {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kSunDistance = 1000;  // radii of the scene

float areaOf(const Mesh& mesh) {
  float twice = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    twice += length(cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]));
  return twice / 2;
}

// `power`: of its surface, or of a point in the middle.
LampPlace placeOf(const ShapeBox& box, int body, float power) {
  return {{static_cast<std::uint32_t>(body + 1), box.centre()}, length(box.high - box.low) / 2, power};
}

LampPlace placeOf(Vec3 position, int body, float power) {
  return {{static_cast<std::uint32_t>(body + 1), position}, 0, power};
}

void addShapes(const Scene& scene, std::vector<LampPlace>& places) {
  const auto add = [&](const auto& shape, float area) {
    ShapeBox box;
    box.add(shape);
    if (emits(shape)) places.push_back(placeOf(box, shape.body, kPi * luminance(shape.radiance) * area));
  };
  for (const Mesh& mesh : scene.meshes) add(mesh, areaOf(mesh));
  for (const Sphere& sphere : scene.spheres) add(sphere, 4 * kPi * sphere.radius * sphere.radius);
}

void addOthers(const Scene& scene, std::vector<LampPlace>& places) {
  for (const PointLight& lamp : scene.point_lights)
    places.push_back(placeOf(lamp.position, lamp.body, 4 * kPi * luminance(lamp.intensity)));
  for (const SpotLight& lamp : scene.spot_lights)
    places.push_back(
        placeOf(lamp.position, lamp.body, 2 * kPi * (1 - std::cos(lamp.cutoff)) * luminance(lamp.intensity)));
  const ShapeBox box = boxOf(scene);
  const float radius = length(box.high - box.low) / 2;
  for (const DirectionalLight& sun : scene.directional_lights)
    places.push_back(placeOf(box.centre() - sun.direction * (kSunDistance * radius), sun.body,
                             kPi * radius * radius * luminance(sun.irradiance)));
}

}  // namespace

std::vector<LampPlace> strongestLamps(const Scene& scene, std::size_t most) {
  std::vector<LampPlace> places;
  addShapes(scene, places);
  addOthers(scene, places);
  std::ranges::stable_sort(places, std::ranges::greater(), &LampPlace::power);
  places.resize(std::min(places.size(), most));
  return places;
}

}  // namespace saccade
