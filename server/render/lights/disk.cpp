#include "render/lights/disk.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

namespace saccade {
namespace {

constexpr std::size_t kFewestCorners = 32, kMostTriangles = 1024;
constexpr float kTolerance = 1e-3f;

std::vector<Vec3> distinctPositions(const Mesh& mesh) {
  std::vector<Vec3> all;
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t i : triangle) all.push_back(mesh.positions[i]);
  std::ranges::sort(all, {}, [](Vec3 p) { return std::tuple(p.x, p.y, p.z); });
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

// Twice the area, along the normal; nothing where a triangle faces another way.
std::optional<Vec3> vectorAreaOf(const Mesh& mesh) {
  Vec3d sum;
  double size = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 each = cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
    sum = sum + toDouble(each), size += double{length(each)};
  }
  if (!(size > 0 && length(sum) > (1 - 1e-5) * size)) return {};
  return toFloat(sum);
}

}  // namespace

std::optional<Disk> diskOf(const Mesh& mesh) {
  if (mesh.triangles.size() + 2 < kFewestCorners || mesh.triangles.size() > kMostTriangles) return {};
  const auto twice_area = vectorAreaOf(mesh);
  if (!twice_area) return {};
  const std::vector<Vec3> positions = distinctPositions(mesh);
  Vec3d sum;
  for (const Vec3 p : positions) sum = sum + toDouble(p);
  const Vec3 center = toFloat(sum / static_cast<double>(positions.size()));
  float radius = 0;
  for (const Vec3 p : positions) radius = std::max(radius, length(p - center));
  const auto isNear = [&](Vec3 p, float distance) {
    return std::abs(length(p - center) - distance) <= kTolerance * radius;
  };
  const auto corners =
      static_cast<std::size_t>(std::ranges::count_if(positions, [&](Vec3 p) { return isNear(p, radius); }));
  const bool has_middle = std::ranges::any_of(positions, [&](Vec3 p) { return isNear(p, 0); });
  if (corners < kFewestCorners || corners + (has_middle ? 1 : 0) != positions.size()) return {};
  // Of all polygons with these corners, the regular one is the largest.
  const float area = length(*twice_area) / 2,
              angle = 2 * std::numbers::pi_v<float> / static_cast<float>(corners);
  const float regular = static_cast<float>(corners) * std::sin(angle) * radius * radius / 2;
  if (!(std::abs(area - regular) <= 2 * kTolerance * regular)) return {};
  return Disk{center, normalize(*twice_area), std::sqrt(area * std::numbers::inv_pi_v<float>)};
}

}  // namespace saccade
