#include "scene/gltf/two_sides.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "scene/mesh/mesh.h"
#include "scene/shape_box.h"

namespace saccade {
namespace {

constexpr float kGap = 1e-4f;  // of the diagonal

// The first vertex at the place of each.
std::vector<std::uint32_t> welded(const Mesh& mesh) {
  std::map<std::tuple<float, float, float>, std::uint32_t> first;
  std::vector<std::uint32_t> all;
  for (const Vec3 p : mesh.positions)
    all.push_back(first.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(all.size())).first->second);
  return all;
}

// Unit, per vertex: the mean of the triangles around it.
std::vector<Vec3> meanNormals(const Mesh& mesh) {
  std::vector<Vec3> normals(mesh.positions.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 n = cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
    for (const std::uint32_t corner : {a, b, c}) normals[corner] = normals[corner] + n;
  }
  for (Vec3& n : normals) n = length(n) > 0 ? normalize(n) : Vec3{};
  return normals;
}

}  // namespace

bool isOpen(const Mesh& mesh) {
  const std::vector<std::uint32_t> place = welded(mesh);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> triangles;  // of each edge
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) ++triangles[std::minmax({place[t[i]], place[t[(i + 1) % 3]]})];
  return std::ranges::any_of(triangles, [](const auto& edge) { return edge.second == 1; });
}

Mesh backOf(const Mesh& mesh) {
  ShapeBox box;
  box.add(mesh);
  const float gap = kGap * length(box.high - box.low);
  Mesh back = mesh;
  const std::vector<Vec3> normals = meanNormals(mesh);
  for (std::size_t i = 0; i < normals.size(); ++i) back.positions[i] = mesh.positions[i] - normals[i] * gap;
  turnRound(back);
  return back;
}

}  // namespace saccade
