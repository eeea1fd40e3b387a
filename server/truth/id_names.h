// The names of what the channel `ids` numbers.
#pragma once

#include "saccade/v1/control.pb.h"
#include "scene/scene.h"

namespace saccade {

// The bounds that IdNames states.
inline constexpr std::size_t kMaxIdNames = 4096, kMaxIdNameBytes = 64;

// Whether its events or its truth have such numbers.
bool asksForIds(const v1::OpenStream& request);

// Those of the scene file. A name that several have gets "_" and the number, such as "rectangle_3", but for
// the shapes of a body, which have one number. Bodies of lamps alone follow the shapes.
v1::IdNames idNames(const Scene& scene);

}  // namespace saccade
