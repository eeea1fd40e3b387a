// The box around shapes, in the scene's axes.
#pragma once

#include <algorithm>
#include <limits>

#include "scene/scene.h"

namespace saccade {

struct ShapeBox {
  void add(Vec3 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  void add(const ShapeBox& box) { add(box.low), add(box.high); }
  void add(const Mesh& mesh) {
    for (const auto& triangle : mesh.triangles)
      for (const std::uint32_t corner : triangle) add(mesh.positions[corner]);
  }
  void add(const Sphere& sphere) {
    const Vec3 half = Vec3{1, 1, 1} * sphere.radius;
    add(sphere.center - half), add(sphere.center + half);
  }
  Vec3 centre() const { return (low + high) * 0.5f; }

  static constexpr float kFar = std::numeric_limits<float>::max();
  Vec3 low{kFar, kFar, kFar}, high{-kFar, -kFar, -kFar};  // without any shape, low is above high
};

// Around all shapes of a scene, in the places that its file gives them.
inline ShapeBox boxOf(const Scene& scene) {
  ShapeBox box;
  for (const Mesh& mesh : scene.meshes) box.add(mesh);
  for (const Sphere& sphere : scene.spheres) box.add(sphere);
  return box;
}

}  // namespace saccade
