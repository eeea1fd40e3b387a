#include "render/world/posed_lamps.h"

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
  return lamps;
}

}  // namespace

PosedLamps::PosedLamps(const Scene& scene, const Lights& still)
    : shapes(lampsOf(scene)), lights(still), analytic(shapes), columns(lights.lamps(), analytic) {}

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
  lights.setLamps(Lamps(shapes, scene.textures));
  analytic = AnalyticLight(shapes);
  columns = LightColumns(lights.lamps(), analytic);
}

}  // namespace saccade
