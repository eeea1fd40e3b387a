#include "render/world/shape_rows.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace saccade {
namespace {

ShapeRow row(const Scene& scene, const auto& shape) {
  const Material& material = scene.materials[static_cast<std::size_t>(shape.material)];
  ShapeRow row;
  row.reflectance = material.reflectance.color0;
  row.textured = isTextured(material.reflectance);
  row.twosided = material.twosided;
  row.emits = emits(shape);
  row.plain = material.model.kind == BsdfKind::kDiffuse && isOpaque(material) && !isBumpy(material) &&
              !isTextured(material.emission);
  return row;
}

}  // namespace

float longestEdge(const Mesh& mesh) {
  float longest2 = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      const Vec3 edge = mesh.positions[to] - mesh.positions[from];
      longest2 = std::max(longest2, dot(edge, edge));
    }
  return std::sqrt(longest2);
}

std::vector<ShapeRow> shapeRows(const Scene& scene) {
  std::vector<ShapeRow> rows;
  for (const Mesh& mesh : scene.meshes) {
    rows.push_back(row(scene, mesh));
    rows.back().triangles = mesh.triangles.data();
    if (!mesh.normals.empty()) rows.back().normals = mesh.normals.data();
    rows.back().edge = longestEdge(mesh);
  }
  for (const Sphere& sphere : scene.spheres) {
    rows.push_back(row(scene, sphere));
    rows.back().edge = 2 * sphere.radius;
  }
  return rows;
}

}  // namespace saccade
