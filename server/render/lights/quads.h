// Flat lamps of two triangles.
#pragma once

#include "scene/scene.h"

namespace saccade {

// Whether the second triangle goes on where the first ends, in its plane: (a, b, c) and (a, c, d), as of a
// rectangle.
inline bool isQuad(const Mesh& mesh, std::size_t i) {
  if (i + 1 >= mesh.triangles.size()) return false;
  const auto &s = mesh.triangles[i], &t = mesh.triangles[i + 1];
  if (t[0] != s[0] || t[1] != s[2]) return false;
  const auto normal = [&](const auto& v) {
    return cross(mesh.positions[v[1]] - mesh.positions[v[0]], mesh.positions[v[2]] - mesh.positions[v[0]]);
  };
  const Vec3 m = normal(s), n = normal(t);
  return dot(m, n) > 0.99999f * length(m) * length(n);
}

}  // namespace saccade
