// Lamps of KHR_lights_punctual.
#pragma once

#include <string>

#include "base/affine.h"
#include "scene/gltf/json_node.h"
#include "scene/scene.h"

namespace saccade {

struct GltfLamp {
  std::string name;  // of its body
  Affine to_world;   // when animations begin
};

// Adds the lamp of a node, if it has one, and returns whether it has. Throws SceneError.
//
// Lamps of glTF are in candela and lux, and its surfaces in candela per square metre. One candela per square
// metre is a radiance of 1 here. Blender's exporter gives radiant units to surfaces, and 683 lumens per watt
// to lamps: the lamps of its files are divided by 683.
bool addLight(const JsonNode& root, const JsonNode& node, const GltfLamp& lamp, Scene& scene);

// As floats; throws SceneError where a part is not within [0, kMaxRadiance].
Rgb checkedLight(const JsonNode& of, Vec3d light);

}  // namespace saccade
