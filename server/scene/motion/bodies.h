// Bodies: shapes of a scene that move, by their names.
#pragma once

#include <set>
#include <span>
#include <string>

#include "scene/scene.h"

namespace saccade {

inline constexpr std::size_t kMostBodies = 256;

std::set<std::string> shapeNames(const Scene& scene);

// Makes all shapes with one of these names a body. A scene has no other bodies. Throws SceneError, which
// lists the names that the scene has, where it has no such shape, or a name comes twice.
void setBodies(Scene& scene, std::span<const std::string> names);

}  // namespace saccade
