// The sky of a glTF file: SACCADE_sky of its scene, an extension of ours.
//
//   radiance   [R, G, B], linear, at least 0; with a picture a factor on it; default [1, 1, 1]
//   picture    a file that OpenImageIO reads, by latitude and longitude, as Environment says
//   rotation   [x, y, z, w], turns the picture's directions to the scene's; default [0, 0, 0, 1]
//
// The picture's path is relative to the glTF file.
#pragma once

#include "scene/files/file_loads.h"
#include "scene/gltf/gltf_file.h"
#include "scene/scene.h"

namespace saccade {

// Sets Scene::environment where the file has a sky. `loads` will read its picture while `scene` stands.
// Throws SceneError.
void addSky(const GltfFile& file, FileLoads& loads, Scene& scene);

}  // namespace saccade
