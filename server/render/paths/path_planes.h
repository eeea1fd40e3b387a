// The paths of a tile as planes of numbers, so that one instruction works on many paths.
#pragma once

#include <array>
#include <cstdint>

#include "base/wide.h"
#include "render/surface/path_start.h"

namespace saccade {

inline constexpr int kBatchPaths = 1024;             // traced together: their planes fit a core's own cache
inline constexpr int kBatchRoom = kBatchPaths + 16;  // lanes may read and write past the last path

struct alignas(64) Plane : std::array<float, kBatchRoom> {};
struct alignas(64) BitPlane : std::array<std::uint32_t, kBatchRoom> {};

template <int Channels>
struct ColorPlanes {
  std::array<Plane, Channels> of;
  Color<Channels> at(std::uint32_t i) const {
    if constexpr (Channels == 1) return Color<1>(of[0][i]);
    if constexpr (Channels == 3) return Color<3>(Rgb{of[0][i], of[1][i], of[2][i]});
  }
  void set(std::uint32_t i, Color<Channels> c) {
    if constexpr (Channels == 1) of[0][i] = c.y;
    if constexpr (Channels == 3) of[0][i] = c.c.x, of[1][i] = c.c.y, of[2][i] = c.c.z;
  }
  void add(std::uint32_t i, Color<Channels> c) { set(i, at(i) += c); }
};

struct VectorPlanes {
  Plane x, y, z;
  Vec3 at(std::uint32_t i) const { return {x[i], y[i], z[i]}; }
  void set(std::uint32_t i, Vec3 v) { x[i] = v.x, y[i] = v.y, z[i] = v.z; }
  template <int W>
  Vec3T<Floats<W>> lanes(int first) const {
    return {load<W>(&x[first]), load<W>(&y[first]), load<W>(&z[first])};
  }
};

// Of rough plastics with GGX microfacets; LivePaths::reflectance is that of their base, plasticBase().
template <int Channels>
struct PlasticPlanes {
  ColorPlanes<Channels> specular;
  Plane alpha, ior;
  Plane transmittance;         // towards the direction that the path came from, over its mean
  Plane specular_probability;  // of sampling the interface
};

// The state of a path from one vertex to the next. A path is at its vertex, and about to choose a direction.
template <int Channels>
struct LivePaths {
  int count = 0;
  VectorPlanes origin;  // of rays from it, on the side that the path came from
  VectorPlanes geometric_normal, shading_normal;
  ColorPlanes<Channels> reflectance;  // of diffuse surfaces
  ColorPlanes<Channels> throughput;
  Plane width, spread;                // of its cone, at the vertex
  BitPlane reversed_index, path_key;  // PathSampler's
  BitPlane slot;                      // its place among PathResults
  // Where surfaces are not all diffuse:
  BitPlane state;               // see path_state.h
  Plane pdf;                    // of the last direction that was not straight on, see Choice
  Plane distance;               // since then
  VectorPlanes chooser_normal;  // geometric, of the vertex that it left; where lamps have a tree
  VectorPlanes arriving;
  PlasticPlanes<Channels> plastic;
  std::array<Surface, kBatchRoom> surfaces;
};

// The results of paths, each at its own place.
template <int Channels>
struct PathResults {
  ColorPlanes<Channels> radiance;
  // Split: components of the direct light of the first vertex, per unit of albedo but for the last. Of lamps
  // whose light has a closed form: all of it, what no surface blocks, and the paths' own estimate by MIS.
  ColorPlanes<Channels> unoccluded, visible, mis_weighted;
  ColorPlanes<Channels> before, carried;  // of paths split at their second vertex, see endsAtKnownLight()
  std::array<Rgb, kBatchRoom> suffix_albedo;
  std::array<std::uint64_t, kBatchRoom> suffix_cell;
  std::array<bool, kBatchRoom> touched;  // whether a ray may find something else before Tracing::moved
};

}  // namespace saccade
