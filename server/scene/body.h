// Shapes and lamps of a scene that move together, by their name.
#pragma once

#include <string>

#include "base/vec.h"

namespace saccade {

inline constexpr int kStands = -1;  // instead of the number of a body

// Its pose at a time is where its centre lies, and how it has turned about it. In the scene file's own place
// it has the pose {centre, no rotation}. Meshes that deform do so in that place.
struct Body {
  std::string name;  // of its shapes and lamps
  // Corners of the box around its shapes in the scene file, as they are at stream time 0. Without shapes it
  // is around its points and spots. Without these it is the origin of the scene's axes.
  Vec3 low, high;
  bool has_shapes = true;

  Vec3 centre() const { return (low + high) * 0.5f; }
};

}  // namespace saccade
