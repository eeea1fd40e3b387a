// Parts of a mesh by their materials.
#pragma once

#include <cstddef>
#include <vector>

#include "scene/scene.h"

namespace saccade {

// The triangles from `begin` to before `end` have this material.
struct MaterialRange {
  std::size_t begin, end;
  int material;
};

// A mesh for each material that has triangles, in the order of materials. `mesh` has been placed, see
// placeMesh(), and so have the results. Each triangle is in one of the ranges.
std::vector<Mesh> splitMesh(Mesh mesh, const std::vector<MaterialRange>& ranges);

}  // namespace saccade
