// Resolves the objects that a request moves.
#pragma once

#include <string>
#include <vector>

#include "app/request/resolved_stream.h"
#include "scene/scene.h"

namespace saccade {

// Checks what needs no loaded scene, reads keyframes and csv, and sorts the objects by name: equal feeds have
// equal keys. The first pose of the camera's csv is at stream time 0, or else the earliest of the objects'
// csv. checkTrajectory() comes first. Throws Refusal.
void checkObjects(ResolvedStream& stream);

// Adds the objects that `scene` moves, and removes those that stand anyway. Throws Refusal where the scene
// lacks an object or its motion, with the names that there are. It also does where the request wants a scene
// that stands.
void fitObjects(const Scene& scene, ResolvedStream& stream);

// Of the objects that may move, in order: the bodies of the stream.
std::vector<std::string> bodyNames(const v1::OpenStream& request);

// The names of bodies that stand until they are steered. Such bodies keep their form.
std::vector<std::string> rigidNames(const v1::OpenStream& request);

// Gives the feeds the paths of the bodies of `scene`, and counts what their lamps and forms take.
void setBodyPaths(const Scene& scene, ResolvedStream& stream);

}  // namespace saccade
