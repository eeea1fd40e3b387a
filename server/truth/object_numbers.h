// The numbers of objects in truth.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace saccade {

// By shape, meshes before spheres: its place counted from 1 on. The shapes of a body have the number of their
// first one.
std::vector<std::uint32_t> objectNumbers(const Scene& scene);

// By body. Those without shapes have the numbers after all shapes, in their order.
std::vector<std::uint32_t> bodyNumbers(const Scene& scene);

}  // namespace saccade
