// Scenes of a single mesh file, OBJ with its materials or PLY, under a default light and before a default
// camera.
//
// Of a material of an OBJ file these are read (see mtl_file.h):
//   Kd, map_Kd     a diffuse colour, seen from both sides; a picture comes in place of Kd
//   Ks with Ns     if Ks is not black: a roughplastic of that colour, with alpha = sqrt(2 / (Ns + 2))
//   d, Tr, map_d   opacity: light goes straight on through the rest
//   Ke             radiance; a file with such light has no default one
// Faces without a material are of a grey of 0.5. All parts of the file are one object, named by the file.
#pragma once

#include <string>

#include "scene/files/load_options.h"
#include "scene/scene.h"

namespace saccade {

// All throw SceneError, which names the file and, where it has lines, the line. A file of materials that is
// not where its name leads is looked up beside the mesh. Scene::unread tells if it is absent. A picture that
// is absent is an error.
Scene loadObjScene(const std::string& path, const LoadOptions& options = {});
Scene loadPlyScene(const std::string& path, const LoadOptions& options = {});
// The same without reading any file: a mesh that has a name alone. Throws where the file may not be read.
Scene outlineModelScene(const std::string& path, const LoadOptions& options);

}  // namespace saccade
