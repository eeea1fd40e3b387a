#include "render/world/posed_lamps.h"

#include "scene/motion/bodies.h"

namespace saccade {
namespace {

Mesh lampOf(const Mesh& mesh) {
  if (emits(mesh)) return mesh;
  Mesh none;
  none.radiance = {};
  return none;
}

Scene lampsOf(const Scene& scene) {
  Scene lamps;
  lamps.materials = scene.materials;
  for (const Mesh& mesh : scene.meshes) lamps.meshes.push_back(lampOf(mesh));
  lamps.spheres = scene.spheres;
  lamps.point_lights = scene.point_lights;
  lamps.spot_lights = scene.spot_lights;
  lamps.directional_lights = scene.directional_lights;
  return lamps;
}

// Where the lamps of `from` are, and where they shine.
void placeDeltas(const Scene& from, std::span<const RigidMotion> motions, Scene& to) {
  const auto motionOf = [&](const auto& lamp) {
    return lamp.body == kStands ? RigidMotion{} : motions[static_cast<std::size_t>(lamp.body)];
  };
  for (std::size_t i = 0; i < from.point_lights.size(); ++i)
    to.point_lights[i].position = motionOf(from.point_lights[i]).point(from.point_lights[i].position);
  for (std::size_t i = 0; i < from.spot_lights.size(); ++i) {
    const RigidMotion motion = motionOf(from.spot_lights[i]);
    to.spot_lights[i].position = motion.point(from.spot_lights[i].position);
    to.spot_lights[i].axis = motion.direction(from.spot_lights[i].axis);
  }
  for (std::size_t i = 0; i < from.directional_lights.size(); ++i)
    to.directional_lights[i].direction =
        motionOf(from.directional_lights[i]).direction(from.directional_lights[i].direction);
}

}  // namespace

PosedLamps::PosedLamps(const Scene& scene, const Lights& still)
    : bodies(lampBodies(scene)),
      shapes(lampsOf(scene)),
      lights(still),
      deltas(shapes, still.lamps()),
      analytic(shapes),
      columns(lights.lamps(), analytic) {}

void PosedLamps::place(const Scene& scene, std::span<const RigidMotion> motions) {
  for (std::size_t i = 0; i < shapes.meshes.size(); ++i) {
    Mesh& mesh = shapes.meshes[i];
    if (mesh.body == kStands || !emits(mesh)) continue;
    const RigidMotion& motion = motions[static_cast<std::size_t>(mesh.body)];
    for (std::size_t k = 0; k < mesh.positions.size(); ++k)
      mesh.positions[k] = motion.point(scene.meshes[i].positions[k]);
  }
  for (std::size_t i = 0; i < shapes.spheres.size(); ++i) {
    Sphere& sphere = shapes.spheres[i];
    if (sphere.body != kStands)
      sphere.center = motions[static_cast<std::size_t>(sphere.body)].point(scene.spheres[i].center);
  }
  placeDeltas(scene, motions, shapes);
  lights.setLamps(Lamps(shapes, scene.textures));
  lights.setSuns(shapes.directional_lights);
  deltas = DeltaLamps(shapes, lights.lamps());
  analytic = AnalyticLight(shapes);
  columns = LightColumns(lights.lamps(), analytic);
}

}  // namespace saccade
