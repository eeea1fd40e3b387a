#include "scene/mesh/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace saccade {
namespace {

// A square with corner `origin` spanned by two edges, its normal along their cross product. `uvs` are those
// of the corners, in the order origin, origin + a, origin + a + b, origin + b.
void addSquare(Mesh& mesh, Vec3 origin, Vec3 a, Vec3 b, const std::array<Vec2, 4>& uvs) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const Vec3 corner : {origin, origin + a, origin + a + b, origin + b}) mesh.positions.push_back(corner);
  mesh.uvs.insert(mesh.uvs.end(), uvs.begin(), uvs.end());
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
}

Vec3d unitOr(Vec3d v, Vec3d fallback) {
  const double l = length(v);
  return l > 0 && std::isfinite(l) ? v / l : fallback;
}

double angleBetween(Vec3d a, Vec3d b) {
  return std::atan2(length(cross(a, b)), dot(a, b));
}

std::vector<Vec3> smoothNormals(const Mesh& mesh) {
  std::vector<Vec3d> sums(mesh.positions.size());
  for (const auto& t : mesh.triangles) {
    const Vec3d p[3] = {toDouble(mesh.positions[t[0]]), toDouble(mesh.positions[t[1]]),
                        toDouble(mesh.positions[t[2]])};
    const Vec3d face = unitOr(cross(p[1] - p[0], p[2] - p[0]), {});
    for (std::size_t i = 0; i < 3; ++i)
      sums[t[i]] = sums[t[i]] + face * angleBetween(p[(i + 1) % 3] - p[i], p[(i + 2) % 3] - p[i]);
  }
  std::vector<Vec3> normals(sums.size());
  std::transform(sums.begin(), sums.end(), normals.begin(), [](Vec3d sum) {
    return toFloat(unitOr(sum, {0, 0, 1}));
  });
  return normals;
}

void reverseTriangles(Mesh& mesh) {
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
}

// Reverses triangles that face away from the normals of their corners.
void turnToNormals(Mesh& mesh) {
  for (auto& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
    const Vec3 mean = mesh.normals[t[0]] + mesh.normals[t[1]] + mesh.normals[t[2]];
    if (dot(cross(b - a, c - a), mean) < 0) std::swap(t[1], t[2]);
  }
}

}  // namespace

Mesh makeRectangle() {
  Mesh mesh;
  addSquare(mesh, {-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  return mesh;
}

Mesh makeCube() {
  constexpr std::array<Vec2, 4> kUvs{{{0, 1}, {1, 1}, {1, 0}, {0, 0}}};
  Mesh mesh;
  addSquare(mesh, {1, -1, -1}, {0, 0, 2}, {-2, 0, 0}, kUvs);
  addSquare(mesh, {1, 1, -1}, {-2, 0, 0}, {0, 0, 2}, kUvs);
  addSquare(mesh, {1, -1, -1}, {0, 2, 0}, {0, 0, 2}, kUvs);
  addSquare(mesh, {1, -1, 1}, {0, 2, 0}, {-2, 0, 0}, kUvs);
  addSquare(mesh, {-1, -1, 1}, {0, 2, 0}, {0, 0, -2}, kUvs);
  addSquare(mesh, {1, 1, -1}, {0, -2, 0}, {-2, 0, 0}, kUvs);
  return mesh;
}

// Each triangle has a vertex of its own in the middle, because v differs there.
Mesh makeDisk() {
  Mesh mesh;
  for (int i = 0; i <= kDiskCorners; ++i) {
    const float turns = static_cast<float>(i) / kDiskCorners;
    const double angle = 2 * std::numbers::pi * (i % kDiskCorners) / kDiskCorners;
    mesh.positions.push_back(toFloat(Vec3d{std::cos(angle), std::sin(angle), 0}));
    mesh.uvs.push_back({1, turns});
  }
  for (std::uint32_t i = 0; i < kDiskCorners; ++i) {
    mesh.triangles.push_back({static_cast<std::uint32_t>(mesh.positions.size()), i, i + 1});
    mesh.positions.push_back({});
    mesh.uvs.push_back({0, (static_cast<float>(i) + 0.5f) / kDiskCorners});
  }
  return mesh;
}

void placeMesh(Mesh& mesh, const Affine& to_world, bool face_normals) {
  for (Vec3& p : mesh.positions) p = toFloat(mapPoint(to_world, toDouble(p)));
  if (determinant(to_world) < 0) reverseTriangles(mesh);
  if (face_normals) {
    mesh.normals.clear();
  } else if (mesh.normals.empty()) {
    mesh.normals = smoothNormals(mesh);
  } else {
    for (Vec3& n : mesh.normals) n = toFloat(unitOr(mapNormal(to_world, toDouble(n)), {0, 0, 1}));
    turnToNormals(mesh);
  }
  mesh.positions.push_back({});
  mesh.positions.shrink_to_fit();
  mesh.normals.shrink_to_fit();
  mesh.uvs.shrink_to_fit();
  mesh.triangles.shrink_to_fit();
}

void turnRound(Mesh& mesh) {
  reverseTriangles(mesh);
  for (Vec3& n : mesh.normals) n = -n;
}

}  // namespace saccade
