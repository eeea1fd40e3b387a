// Lamps of KHR_lights_punctual, and an even sky.
#pragma once

#include "scene/affine.h"
#include "scene/gltf/json_node.h"
#include "scene/scene.h"

namespace saccade {

// Adds the lamp of a node, if it has one. Throws SceneError.
//
// Lamps of glTF are in candela and lux, and its surfaces in candela per square metre. One candela per square
// metre is a radiance of 1 here. Blender's exporter gives radiant units to surfaces, and 683 lumens per watt
// to lamps: the lamps of its files are divided by 683.
void addLight(const JsonNode& root, const JsonNode& node, const Affine& to_world, Scene& scene);

// Adds the even sky of SACCADE_sky, an extension of ours of the file's scene, if it has one. It is
// {"radiance": [R, G, B]}, linear and at least 0. Throws SceneError.
void addSky(const JsonNode& root, Scene& scene);

}  // namespace saccade
