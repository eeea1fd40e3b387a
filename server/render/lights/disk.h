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

// The disk that a mesh stands for, such as one of makeDisk() or a disk of Blender. Such a mesh is a regular
// polygon of 32 corners or more, in at most 1024 triangles. The disk has the same area, so that its light
// differs at the edge alone. Of other meshes, such as ellipses: nothing.
std::optional<Disk> diskOf(const Mesh& mesh);

}  // namespace saccade
