#include "render/world/shape_rows.h"

namespace saccade {
namespace {

ShapeRow row(const Scene& scene, const auto& shape) {
  const Material& material = scene.materials[static_cast<std::size_t>(shape.material)];
  ShapeRow row;
  row.reflectance = material.reflectance.color0;
  row.textured = isTextured(material.reflectance);
  row.twosided = material.twosided;
  row.emits = emits(shape);
  row.plain = material.model.kind == BsdfKind::kDiffuse && isOpaque(material) && !isBumpy(material);
  return row;
}

}  // namespace

std::vector<ShapeRow> shapeRows(const Scene& scene) {
  std::vector<ShapeRow> rows;
  for (const Mesh& mesh : scene.meshes) {
    rows.push_back(row(scene, mesh));
    rows.back().triangles = mesh.triangles.data();
    if (!mesh.normals.empty()) rows.back().normals = mesh.normals.data();
  }
  for (const Sphere& sphere : scene.spheres) rows.push_back(row(scene, sphere));
  return rows;
}

}  // namespace saccade
