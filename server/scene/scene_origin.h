// Scenes in map coordinates: floats are too coarse far from 0.
#pragma once

#include "scene/scene.h"

namespace saccade {

// Where the origin of a scene's axes should lie, for a scene that was read with its origin at 0. A coordinate
// is 0 if the scene's centre is at most 128 of its diagonals away from 0 along that axis. Beyond, an ulp of a
// position is as large as the step by which rays leave surfaces. There it is the centre, rounded to a
// multiple of the power of two above the diagonal.
Vec3d originOf(const Scene& scene);

// The scene that `load` gives for an origin. It is loaded once more where its floats would be too coarse.
template <class Load>
Scene loadAtOrigin(const Load& load) {
  Scene scene = load(Vec3d{});
  const Vec3d origin = originOf(scene);
  if (origin == Vec3d{}) return scene;
  scene = {};  // frees its memory first
  return load(origin);
}

}  // namespace saccade
