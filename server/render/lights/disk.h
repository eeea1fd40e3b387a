// Lamps in the form of a disk.
#pragma once

#include <optional>

#include "scene/scene.h"

namespace saccade {

struct Disk {
  Vec3 center;
  Vec3 normal;  // unit, to the bright side
  float radius;
};

// The disk that a mesh stands for, such as one of makeDisk(). Such a mesh is a regular polygon, as a fan of
// at least 64 triangles about its centre. The disk has the same area, so that its light differs at the edge
// alone. Of other meshes, such as ellipses: nothing.
std::optional<Disk> diskOf(const Mesh& mesh);

}  // namespace saccade
