#include "render/tiles/known_rays.h"

#include <algorithm>

namespace saccade {
namespace {

// Whether two points of a surface are near, and their facets meet at less than 8 degrees.
bool isOneFacet(const RayFacet& a, const RayFacet& b) {
  constexpr float kNear = 0.25f;  // pixels
  constexpr float kLeastCosine = 0.99f;
  const Vec3 way = b.position - a.position;
  return dot(way, way) < kNear * kNear * a.footprint * a.footprint && dot(a.normal, b.normal) > kLeastCosine;
}

}  // namespace

std::uint32_t KnownRays::add(const RayFacet& from, std::span<const RayBits> of_groups) {
  std::ranges::copy(of_groups, rays_.emplace_back(Rays{from, {}}).bits.begin());
  return static_cast<std::uint32_t>(rays_.size() - 1);
}

KnownRays::Bits KnownRays::between(std::uint32_t a, std::uint32_t b, const RayFacet& at) const {
  if (a == kNone || b == kNone) return {};
  const Rays &before = rays_[a], &after = rays_[b];
  if (!isOneFacet(at, before.from) || !isOneFacet(at, after.from)) return {};
  Bits both;
  for (std::size_t g = 0; g < both.size(); ++g)
    both[g] = {before.bits[g].lit & after.bits[g].lit, before.bits[g].dark & after.bits[g].dark};
  return both;
}

}  // namespace saccade
