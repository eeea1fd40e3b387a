// Light that paths find where their rays end.
#pragma once

#include <limits>

#include "render/paths/path_planes.h"
#include "render/paths/tracing.h"
#include "render/sampling/path_sampler.h"

namespace saccade {

// An emitter that a path has hit. That is direct light of the vertex before.
struct Found {
  std::uint32_t slot;
  EmitterPoint emitter;
  Receiver vertex;  // that could have sampled it
};

// The vertex that chose the direction of a path, whose ray has hit `point`.
template <bool kMixed, int C>
[[gnu::always_inline]] inline Receiver chooserOf(const LivePaths<C>& from, std::uint32_t path, Vec3 point,
                                                 Vec3 direction, float distance) {
  const bool straight_on = kMixed && from.distance[path] > 0;
  return {point - direction * distance,
          straight_on ? from.chooser_normal.at(path) : from.geometric_normal.at(path)};
}

inline constexpr float kDeltaPdf =
    std::numeric_limits<float>::infinity();  // samples of the lights cannot find it

// Adds it to what a path has found, whose direction was sampled with `pdf`. `from_start` tells whether the
// first vertex chose that direction.
template <int C, bool kSplit>
void addFound(const Tracing& t, const Found& found, Color<C> throughput, float pdf, bool from_start,
              PathResults<C>& results);

// The second vertex of a path, off an opaque surface with a diffuse base.
struct SecondVertex {
  Vec3 point, normal;
  Rgb albedo;
  float width;  // of the cone
};

// Light that is known there is added, and ends most paths. Returns whether it ends this one. Otherwise, if
// the vertex can be cached, the radiance of the path's suffix is accumulated separately from here on.
template <int C>
bool endsAtKnownLight(const Tracing& t, const SecondVertex& v, const PathSampler& sampler, std::uint32_t slot,
                      Color<C>& throughput, PathResults<C>& results);

}  // namespace saccade
