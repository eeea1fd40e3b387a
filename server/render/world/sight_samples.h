// Samples of what surfaces see of a scene's lamps.
#pragma once

#include <vector>

#include "render/lights/lamps.h"
#include "render/world/embree_scene.h"
#include "render/world/shape_rows.h"

namespace saccade {

// Rays from all lamps find the surfaces that are lit. There a lamp of each group at the tree's root is looked
// for. `rows`: of the shapes. There must be a tree.
std::vector<SightSample> sightSamples(const Lamps& lamps, LightSet set, const EmbreeScene& geometry,
                                      const std::vector<ShapeRow>& rows);

}  // namespace saccade
