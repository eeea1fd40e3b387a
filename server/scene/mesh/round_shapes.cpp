#include "scene/mesh/round_shapes.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace saccade {
namespace {

// A grid of `rows` by kRoundCorners squares over [0, 1]^2, of which at(u, v) gives the position and the
// normal.
template <class At>
Mesh makeGrid(int rows, At at) {
  Mesh mesh;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= kRoundCorners; ++i) {
      const double u = static_cast<double>(i) / kRoundCorners, v = static_cast<double>(j) / rows;
      const auto [position, normal] = at(u, v);
      mesh.positions.push_back(toFloat(position));
      mesh.normals.push_back(toFloat(normal));
      mesh.uvs.push_back({static_cast<float>(u), static_cast<float>(v)});
    }
  constexpr std::uint32_t kRow = kRoundCorners + 1;
  const auto add = [&mesh](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const auto& p = mesh.positions;
    if (p[a] != p[b] && p[b] != p[c] && p[c] != p[a]) mesh.triangles.push_back({a, b, c});
  };
  for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(rows); ++j)
    for (std::uint32_t i = 0; i < kRoundCorners; ++i) {
      const std::uint32_t a = j * kRow + i, b = a + kRow;
      add(a, a + 1, b + 1);
      add(a, b + 1, b);
    }
  return mesh;
}

struct Point {
  Vec3d position, normal;
};

// Of the angle around the z axis, in turns.
Vec3d around(double turns) {
  const double angle = 2 * std::numbers::pi * (turns == 1 ? 0 : turns);
  return {std::cos(angle), std::sin(angle), 0};
}

}  // namespace

Mesh makeCylinder() {
  return makeGrid(1, [](double u, double v) { return Point{around(u) + Vec3d{0, 0, v}, around(u)}; });
}

Mesh makeSphere() {
  Mesh mesh = makeGrid(kRoundCorners / 2, [](double u, double v) {
    const double angle = std::numbers::pi * v, ring = v == 0 || v == 1 ? 0 : std::sin(angle);
    const Vec3d p = around(u) * ring + Vec3d{0, 0, std::cos(angle)};
    return Point{p, p};
  });
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);  // v goes down
  return mesh;
}

}  // namespace saccade
