#include "scene/mesh/creases.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <span>
#include <vector>

namespace saccade {
namespace {

constexpr std::size_t kMostGroups = 64;  // of faces around one vertex, among which a face looks for its own

std::vector<Vec3d> faceNormals(const Mesh& mesh, const Affine& to_world) {
  std::vector<Vec3d> normals;
  for (const auto& t : mesh.triangles) {
    const auto at = [&](std::size_t i) { return mapPoint(to_world, toDouble(mesh.positions[t[i]])); };
    const Vec3d n = cross(at(1) - at(0), at(2) - at(0));
    const double l = length(n);
    normals.push_back(l > 0 && std::isfinite(l) ? n / l : Vec3d{});
  }
  return normals;
}

// The place and texture coordinates of a vertex as bits, so that numbers that are none have an order, too.
std::array<std::uint32_t, 5> keyOf(const Mesh& mesh, std::uint32_t vertex) {
  const Vec3 p = mesh.positions[vertex];
  const Vec2 uv = mesh.uvs.empty() ? Vec2{} : mesh.uvs[vertex];
  const auto bits = [](float v) { return std::bit_cast<std::uint32_t>(v + 0.f); };  // -0 is 0
  return {bits(p.x), bits(p.y), bits(p.z), bits(uv.x), bits(uv.y)};
}

template <class T>
void take(std::vector<T>& values, const std::vector<std::uint32_t>& from) {
  if (values.empty()) return;
  std::vector<T> taken;
  for (const std::uint32_t i : from) taken.push_back(values[i]);
  values = std::move(taken);
}

// Groups the corners of triangles, each of which is 3 * triangle + corner.
class Groups {
 public:
  Groups(Mesh& mesh, const Affine& to_world, double degrees)
      : mesh_(mesh),
        normals_(faceNormals(mesh, to_world)),
        least_(std::cos(degrees * std::numbers::pi / 180)),
        old_(mesh.triangles) {}

  // Corners around one vertex.
  void add(std::span<const std::uint32_t> corners) {
    std::vector<std::uint32_t> firsts;  // of the groups
    for (const std::uint32_t corner : corners) {
      const auto fits = [&](std::uint32_t first) {
        return dot(normals_[first / 3], normals_[corner / 3]) > least_;
      };
      const auto found = std::ranges::find_if(firsts, fits);
      const bool known = found != firsts.end();
      if (!known && firsts.size() < kMostGroups) firsts.push_back(corner);
      vertexOf(corner) = known ? vertexOf(*found) : newVertex(corner);
    }
  }

  // The vertices, as indices of those of before.
  const std::vector<std::uint32_t>& vertices() const { return vertices_; }

 private:
  std::uint32_t& vertexOf(std::uint32_t corner) { return mesh_.triangles[corner / 3][corner % 3]; }
  std::uint32_t newVertex(std::uint32_t corner) {
    vertices_.push_back(old_[corner / 3][corner % 3]);
    return static_cast<std::uint32_t>(vertices_.size()) - 1;
  }

  Mesh& mesh_;
  const std::vector<Vec3d> normals_;
  const double least_;
  const std::vector<std::array<std::uint32_t, 3>> old_;
  std::vector<std::uint32_t> vertices_;
};

}  // namespace

void splitAtCreases(Mesh& mesh, const Affine& to_world, double degrees) {
  std::vector<std::uint32_t> corners(3 * mesh.triangles.size());
  std::iota(corners.begin(), corners.end(), 0u);
  const auto triangles = mesh.triangles;
  const auto key = [&](std::uint32_t corner) { return keyOf(mesh, triangles[corner / 3][corner % 3]); };
  std::stable_sort(corners.begin(), corners.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  Groups groups(mesh, to_world, degrees);
  for (std::size_t begin = 0, end = 0; begin < corners.size(); begin = end) {
    while (end < corners.size() && key(corners[end]) == key(corners[begin])) ++end;
    groups.add(std::span(corners).subspan(begin, end - begin));
  }
  for (auto* values : {&mesh.uvs, &mesh.second_uvs}) take(*values, groups.vertices());
  take(mesh.colors, groups.vertices());
  take(mesh.positions, groups.vertices());
  mesh.normals.clear();
}

}  // namespace saccade
