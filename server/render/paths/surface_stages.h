// The stages that go path by path, because each path meets another kind of surface. They handle the end of a
// ray, and surfaces that are not plain diffuse. Compiled for each set of features (shading.h).
#pragma once

#include "render/paths/path_planes.h"
#include "render/paths/path_state.h"
#include "render/paths/tracing.h"
#include "render/sampling/path_sampler.h"
#include "render/surface/scatter.h"
#include "render/world/surface_at.h"

namespace saccade {

// Where a ray has come to its end. The rest is valid if the hit is.
struct Arrival {
  Vec3 direction;  // of the ray, unit
  Hit hit;
  Patch patch;
  Vec3 normal;   // geometric, unit, as wound
  float cosine;  // between it and the ray's reverse
};

// A ray that leaves a surface.
struct Departure {
  Vec3 origin, direction;
  bool goes = false;  // else the path ends
};

template <int C>
struct SurfaceStages {
  // Adds a path at its first vertex.
  void (*begin)(const PathStart& start, const PathSampler& sampler, std::uint32_t slot, LivePaths<C>& to);
  // The ray of path i has come to its end. Adds the light that it has found there to the results, and the
  // path to `to` if it goes on. `vertex` is the number of the vertex that the ray left.
  void (*arrive)(const Tracing& t, int vertex, const LivePaths<C>& from, std::uint32_t i, const Arrival& at,
                 LivePaths<C>& to, PathResults<C>& results);
  // Of surfaces that are not diffuse, or let light through. depart() chooses the direction in which path i
  // goes on.
  Departure (*depart)(const Tracing& t, int vertex, LivePaths<C>& paths, std::uint32_t i);
  BsdfValue (*evaluate)(const LivePaths<C>& paths, std::uint32_t i, Vec3 direction);
  // The light that panes and masks let through along a shadow ray, whose first hit with them is given.
  Transmittance (*transmit)(const Tracing& t, const Ray& shadow, const Hit& first);
};

// With light in parts, or without.
template <Shading S, int C, bool kParts>
SurfaceStages<C> surfaceStages();

}  // namespace saccade
