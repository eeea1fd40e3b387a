// Bodies: shapes and lamps of a scene that move, by their names.
#pragma once

#include <set>
#include <span>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace saccade {

inline constexpr std::size_t kMostBodies = 256;

// Of its shapes, and of its lamps that have a name.
std::set<std::string> objectNames(const Scene& scene);

// Of the shapes and lamps with a name; there must be some.
Body bodyNamed(const Scene& scene, const std::string& name);

// Makes all shapes and lamps with one of these names a body. A scene has no other bodies. Throws SceneError,
// which lists the names that the scene has, where it has no such object, or a name comes twice.
void setBodies(Scene& scene, std::span<const std::string> names);

// By body, whether it gives light: as an emissive shape, a point, a spot or a sun.
std::vector<char> lampBodies(const Scene& scene);
bool anyLampMoves(const Scene& scene);  // whether a body does

// Lets the shapes with one of these names keep the form that they have at stream time 0.
void keepForms(Scene& scene, std::span<const std::string> names);

// The time of the last key that changes the form of a body; 0 where none does.
TimeNs lastFormKey(const Scene& scene);

}  // namespace saccade
