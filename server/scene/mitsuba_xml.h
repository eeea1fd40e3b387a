// Reads a Mitsuba 3 scene file.
//
// Supported: perspective sensor (fov along x, or fov_axis y|x|smaller|larger); shapes rectangle, cube,
// sphere, obj, ply; bsdf diffuse under any number of twosided; textures bitmap (to_uv scale/translate, raw)
// and checkerboard; emitter area with rgb or float radiance; to_world of matrix, translate, rotate, scale,
// lookat in order; <default> and $names; ids and refs. Integrator, sampler, film rfilter and the like are
// read past; the film's width and height are kept. Anything else is a SceneError naming file, line and what
// is supported.
#pragma once

#include <map>
#include <string>

#include "scene/scene.h"

namespace saccade {

// `definitions` override the file's <default> values ($name). Relative file names are looked up in the folder
// of the scene file. Throws SceneError.
Scene loadMitsubaXml(const std::string& path, const std::map<std::string, std::string>& definitions = {});

}  // namespace saccade
