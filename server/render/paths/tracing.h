// The input of all stages of a tile's paths.
#pragma once

#include "cache/grid/bounce_grid.h"
#include "render/sampling/path_sampler.h"
#include "render/world/moved_bodies.h"

namespace saccade {

// Light that ends paths at their second vertex.
struct KnownBounces {
  const BounceGrid* grid = nullptr;  // nullptr: there is none
  Vec3 eye;                          // of the camera
  float pixel = 0;                   // width of its pixels at the distance 1
};

struct Tracing {
  const PosedScene& scene;
  int bounces;  // indirect, off rough surfaces; 0: direct light only
  KnownBounces known;
  // First vertices take no samples of points and suns: their light is computed elsewhere.
  bool deltas_apart = false;
  // Nor do paths count the emission that mirrorImage() tells.
  bool images_apart = false;
  // Asks which paths PathResults::touched; nullptr: none.
  const MovedBodies* moved = nullptr;
  // Of split paths only what is not direct light in closed form counts: where all surfaces are diffuse, it is
  // left out.
  bool residual_only = false;

  // Of which the vertex takes samples that chose a direction.
  LightSet lightsOf(bool first_vertex) const {
    return first_vertex && deltas_apart ? LightSet::kWithExtent : LightSet::kAll;
  }
};

// Every vertex has its own random dimensions. So two paths that part at one vertex share the numbers of the
// next. Those of a group are spread evenly together, see PathSampler.
enum Dimension : std::uint32_t { kLight, kBounce = kLight + 3, kLobe = kBounce + 2, kDimensions };
static_assert(kBounce % PathSampler::kGroup == 0 && kDimensions % PathSampler::kGroup == 0);
inline constexpr std::uint32_t kGoOn = 1 << 16;  // of the choice to go on from light that is known

inline constexpr int kMaxDeltas = 16;  // reflections and refractions that do not count as bounces

// Balance heuristic (Veach 1995).
template <class F>
F balance(F pdf, F other) {
  return pdf / (pdf + other);
}

}  // namespace saccade
