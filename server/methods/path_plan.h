// How many paths each point gets, by how well its light is known [ours].
#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include "base/pool_handle.h"
#include "frame/image.h"
#include "frame/surface_samples.h"

namespace saccade {

struct PathPlan {
  float asked;                 // paths per pixel
  float usual;                 // of a pixel whose relative error is `target`; in [0, asked]
  float target;                // relative error that is aimed at
  float most;                  // the mean over a picture of one point per pixel; in [usual, asked]
  float target_of_change = 1;  // as `target`, see PathErrors::change
};

// Errors of estimates at the points of a frame, relative to the light there. They have the columns of
// SurfaceSamples.
struct PathErrors {
  const ImageF& light;
  const ImageF* change = nullptr;  // of the change of light since the frame before; nullptr: there is none
};

// Sets SurfacePoint::paths. The more is known the fewer they are, and none where the light is baked. Points
// that are known badly get eight times those asked, as far as the mean allows. Paths that are left over go to
// points of kNone. `frame` moves the rounding on.
// Points of kNone get more in pixels that showed none in the frame before, and so have neither pairs nor a
// history. `had_others` tells of each pixel whether it did; empty: there is no such frame. It becomes that of
// this frame.
std::chrono::nanoseconds planPaths(const PathPlan& plan, const PathErrors& errors, std::uint32_t frame,
                                   const PoolHandle& pool, std::vector<char>& had_others, SurfaceSamples& on);

}  // namespace saccade
