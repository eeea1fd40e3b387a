#include "scene/motion/bodies.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "base/names.h"
#include "scene/files/scene_error.h"
#include "scene/shape_box.h"

namespace saccade {

namespace {

// Calls `take` with the points, the spots and the suns.
void forLamps(auto& scene, const auto& take) {
  take(scene.point_lights), take(scene.spot_lights), take(scene.directional_lights);
}

void forObjects(auto& scene, const auto& take) {
  take(scene.meshes), take(scene.spheres), forLamps(scene, take);
}

// Around the shapes with a name.
ShapeBox shapesNamed(const Scene& scene, const std::string& name) {
  ShapeBox box;
  const auto take = [&](const auto& shapes) {
    for (const auto& shape : shapes)
      if (shape.name == name) box.add(shape);
  };
  take(scene.meshes), take(scene.spheres);
  return box;
}

ShapeBox lampsNamed(const Scene& scene, const std::string& name) {
  ShapeBox box;
  const auto take = [&](const auto& lamps) {
    for (const auto& lamp : lamps)
      if (lamp.name == name) box.add(lamp.position);
  };
  take(scene.point_lights), take(scene.spot_lights);
  return box;
}

bool hasShapes(const Scene& scene, const std::string& name) {
  const auto isOf = [&](const auto& shape) { return shape.name == name; };
  return std::ranges::any_of(scene.meshes, isOf) || std::ranges::any_of(scene.spheres, isOf);
}

}  // namespace

std::set<std::string> objectNames(const Scene& scene) {
  std::set<std::string> names;
  forObjects(scene, [&](const auto& objects) {
    for (const auto& object : objects) names.insert(object.name);
  });
  names.erase("");
  return names;
}

Body bodyNamed(const Scene& scene, const std::string& name) {
  const bool has_shapes = hasShapes(scene, name);
  const ShapeBox box = has_shapes ? shapesNamed(scene, name) : lampsNamed(scene, name);
  const bool is_nothing = box.low.x > box.high.x;
  return is_nothing ? Body{name, {}, {}, has_shapes} : Body{name, box.low, box.high, has_shapes};
}

void setBodies(Scene& scene, std::span<const std::string> names) {
  SACCADE_CHECK(scene.bodies.empty() && names.size() <= kMostBodies);
  const std::set<std::string> known = objectNames(scene);
  for (const std::string& name : names) {
    const int body = static_cast<int>(scene.bodies.size());
    if (std::ranges::any_of(scene.bodies, [&](const Body& other) { return other.name == name; }))
      throw SceneError("the object '" + name + "' is given twice");
    if (!known.contains(name))
      throw SceneError("the scene has no object '" + name + "'; it has: " + joinNames(known));
    scene.bodies.push_back(bodyNamed(scene, name));
    forObjects(scene, [&](auto& objects) {
      for (auto& object : objects)
        if (object.name == name) object.body = body;
    });
  }
}

std::vector<char> lampBodies(const Scene& scene) {
  std::vector<char> gives_light(scene.bodies.size());
  const auto add = [&](int body) {
    if (body != kStands) gives_light[static_cast<std::size_t>(body)] = true;
  };
  for (const Mesh& mesh : scene.meshes)
    if (emits(mesh)) add(mesh.body);
  for (const Sphere& sphere : scene.spheres)
    if (emits(sphere)) add(sphere.body);
  forLamps(scene, [&](const auto& lamps) {
    for (const auto& lamp : lamps) add(lamp.body);
  });
  return gives_light;
}

bool anyLampMoves(const Scene& scene) {
  return std::ranges::count(lampBodies(scene), true) > 0;
}

void keepForms(Scene& scene, std::span<const std::string> names) {
  for (Mesh& mesh : scene.meshes)
    if (std::ranges::find(names, mesh.name) != names.end()) mesh.deformation = kKeepsForm;
}

TimeNs lastFormKey(const Scene& scene) {
  if (std::ranges::none_of(scene.meshes, deforms)) return TimeNs{0};
  float last = 0;
  const auto take = [&](const KeyTrack& keys) {
    if (!keys.times.empty()) last = std::max(last, keys.times.back());
  };
  for (const MovingNode& node : scene.nodes)
    for (const NodeTrack& track : node.tracks) take(track.keys);
  for (const Deformation& deformation : scene.deformations) take(deformation.weight_keys);
  return TimeNs{std::llround(double{last} * 1e9)};
}

}  // namespace saccade
