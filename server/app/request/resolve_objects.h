// Resolves the objects that a request moves.
#pragma once

#include <string>
#include <vector>

#include "app/request/resolved_stream.h"
#include "scene/scene.h"

namespace saccade {

// Checks what needs no loaded scene, reads keyframes and csv, and sorts the objects by name: equal feeds have
// equal keys. Throws Refusal.
void checkObjects(ResolvedStream& stream);

// Of checked objects, in order.
std::vector<std::string> objectNames(const v1::OpenStream& request);

// Throws Refusal, with the names that there are, where the scene lacks an object.
void findObjects(const Scene& scene, const ResolvedStream& stream);

// Gives the feeds the paths of the bodies of `scene`, which are the objects.
void setBodyPaths(const Scene& scene, ResolvedStream& stream);

}  // namespace saccade
