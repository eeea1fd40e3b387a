// Ends of the shadow rays of pixels at some moments. A ray that ends alike at two close moments does so
// between them, as long as the pixel shows one facet of a surface. On other facets, rays that graze them end
// otherwise every few hundredths of a pixel [ours].
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec.h"
#include "render/lights/analytic_light.h"
#include "render/tiles/ray_bits.h"

namespace saccade {

// Where rays start.
struct RayFacet {
  Vec3 position;  // SurfacePlace::position
  Vec3 normal;    // geometric, unit
  float footprint;
};

class KnownRays {
 public:
  static constexpr std::uint32_t kNone = ~0u;
  using Bits = std::array<RayBits, AnalyticLight::kMaxGroups>;  // by group of lamps

  void clear() { rays_.clear(); }
  // Returns the number of these rays.
  std::uint32_t add(const RayFacet& from, std::span<const RayBits> of_groups);
  // The rays from `at` that end as those of both numbers do. Either may be kNone.
  Bits between(std::uint32_t a, std::uint32_t b, const RayFacet& at) const;

 private:
  struct Rays {
    RayFacet from;
    Bits bits;
  };
  std::vector<Rays> rays_;
};

}  // namespace saccade
