// Reads a glTF 2.0 file: .gltf, or .glb, which holds its buffers and pictures itself.
//
// Supported:
//   node      tree of TRS or matrices; its name is that of an object, unique by "@index"
//   mesh      triangles, strips, fans, with and without indices; NORMAL (else flat), TEXCOORD of any two
//             sets, COLOR_0 without its alpha
//   form      skins of up to 16 joints a vertex, morph targets of POSITION and NORMAL
//   data      sparse, KHR_mesh_quantization, EXT_meshopt_compression, KHR_draco_mesh_compression
//   material  metallic-roughness, normal map, emission and KHR_materials_emissive_strength, alphaMode; both
//             sides; KHR_materials_ior, _specular without textures, _transmission as glass, _volume as solid
//             glass
//   texture   PNG, JPEG, EXT_texture_webp; KHR_texture_transform; repeats, is mirrored, or clamped
//   camera    perspective; each is a named path, and the first the scene's own
//   light     KHR_lights_punctual; our own SACCADE_sky, even or a picture
//   animation of nodes and weights: these are objects with a motion of their own, from stream time 0 on
// A file without a camera or without light has those of addDefaults().
// Scene::unread tells of parts that would change the picture, and are not shown. Required extensions that are
// not supported, and values out of range, are a SceneError that names file and place.
#pragma once

#include <string>

#include "scene/files/load_options.h"
#include "scene/scene.h"

namespace saccade {

// Files are looked up as findFile() says. Throws SceneError.
Scene loadGltf(const std::string& path, const LoadOptions& options);
// The same without reading any buffer or picture: meshes have names alone. Throws SceneError.
Scene outlineGltf(const std::string& path, const LoadOptions& options);
// The names of the animations of a file, in its order; "animation 2" for the third one if it has no name.
// Throws SceneError.
std::vector<std::string> animationsOfGltf(const std::string& path, const LoadOptions& options);

}  // namespace saccade
