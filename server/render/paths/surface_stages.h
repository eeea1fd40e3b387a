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

// The end of a path's ray. All but the direction is valid if the hit is.
struct PathHit {
  Vec3 direction;  // of the ray, unit
  Hit hit;
  Patch patch;
  Vec3 normal;   // geometric, unit, as wound
  float cosine;  // between it and the ray's reverse
};

// A ray in the direction that a BSDF was sampled for.
struct ScatteredRay {
  Vec3 origin, direction;
  bool goes = false;  // else the path ends
};

template <int C>
struct SurfaceStages {
  // Adds a path at its first vertex.
  void (*begin)(const PathStart& start, const PathSampler& sampler, std::uint32_t slot, LivePaths<C>& to);
  // Shades the end of the ray of path i. Light found there is added to the results. The path is added to
  // `to` if it goes on. `vertex` is the number of the vertex that the ray left.
  void (*shadeHit)(const Tracing& t, int vertex, const LivePaths<C>& from, std::uint32_t i, const PathHit& at,
                   LivePaths<C>& to, PathResults<C>& results);
  // Of surfaces that are not diffuse, or let light through. sampleBsdf() chooses the direction in which path
  // i goes on.
  ScatteredRay (*sampleBsdf)(const Tracing& t, int vertex, LivePaths<C>& paths, std::uint32_t i);
  BsdfValue (*evaluate)(const LivePaths<C>& paths, std::uint32_t i, Vec3 direction);
  // The light that panes and masks let through along a shadow ray, whose first hit with them is given.
  Transmittance (*transmit)(const Tracing& t, const Ray& shadow, const Hit& first);
};

// kSplit: see PathKind.
template <Shading S, int C, bool kSplit>
SurfaceStages<C> surfaceStages();

}  // namespace saccade
