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

// The disk that a mesh stands for: a fan of at least 64 triangles about the centre of a regular polygon, in
// one plane, as makeDisk() has it. Its area is that of the mesh, so that its light differs from that of the
// mesh at the edge alone. Nothing where the mesh is none, such as an ellipse.
std::optional<Disk> diskOf(const Mesh& mesh);

}  // namespace saccade
