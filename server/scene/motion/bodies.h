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

// Lets the shapes with one of these names keep the form that they have at stream time 0.
void keepForms(Scene& scene, std::span<const std::string> names);

// The time of the last key that changes the form of a body; 0 where none does.
TimeNs lastFormKey(const Scene& scene);

}  // namespace saccade
