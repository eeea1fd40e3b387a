#include "render/lights/disk.h"

#include <array>
#include <cmath>
#include <numbers>

namespace saccade {
namespace {

constexpr std::size_t kFewest = 64;  // triangles

// One after the other, such as (m, a, b) and (m, b, c), or the other way round.
bool followEachOther(const Mesh& mesh, const std::array<std::uint32_t, 3>& s,
                     const std::array<std::uint32_t, 3>& t) {
  const auto same = [&](std::uint32_t i, std::uint32_t j) { return mesh.positions[i] == mesh.positions[j]; };
  return same(s[0], t[0]) && (same(s[2], t[1]) || same(s[1], t[2]));
}

}  // namespace

std::optional<Disk> diskOf(const Mesh& mesh) {
  constexpr float kTolerance = 1e-4f;
  const std::size_t count = mesh.triangles.size();
  if (count < kFewest) return {};
  const Vec3 center = mesh.positions[mesh.triangles[0][0]];
  const auto spoke = [&](std::size_t i, std::size_t k) {
    return mesh.positions[mesh.triangles[i][k]] - center;
  };
  const Vec3 first = cross(spoke(0, 1), spoke(0, 2));
  const float radius = length(spoke(0, 1)), twice_area = length(first);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 each = cross(spoke(i, 1), spoke(i, 2));
    if (!followEachOther(mesh, mesh.triangles[i], mesh.triangles[(i + 1) % count]) ||
        !(std::abs(length(spoke(i, 1)) - radius) < kTolerance * radius) ||
        !(length(each - first) < 10 * kTolerance * twice_area))
      return {};
  }
  // A fan that turns twice has twice the area.
  const float area = twice_area / 2 * static_cast<float>(count);
  const float of_mean = std::sqrt(area * std::numbers::inv_pi_v<float>);
  if (!(std::abs(of_mean - radius) < 0.01f * radius)) return {};
  return Disk{center, normalize(first), of_mean};
}

}  // namespace saccade
