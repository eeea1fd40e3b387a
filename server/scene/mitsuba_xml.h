// Reads a Mitsuba 3 scene file.
//
// Supported: perspective sensor (fov along x, or fov_axis y|x|smaller|larger); shapes rectangle, cube,
// sphere, obj, ply; bsdf diffuse under any number of twosided; textures bitmap (to_uv scale/translate, raw)
// and checkerboard; emitter area with rgb or float radiance; to_world of matrix, translate, rotate, scale,
// lookat in order; <default> and $names; ids and refs. Integrator, sampler, film rfilter and the like are
// read past; the film's width and height are kept. Anything else is a SceneError naming file, line and what
// is supported.
//
// Our extension: an area emitter may change over stream time, by a factor (dimensionless, at least 0) on its
// radiance.
//   <string name="strength" value="0:1, 0.05:1, 0.05:0.2"/>   keys, seconds:factor, times never decreasing
//   <float name="strength_period" value="0.1"/>               seconds; with it, the keys repeat for ever
// It is linear between keys and held before the first and after the last; two keys at one time switch, and at
// that time the later one holds. Every frame shows the factor at its time, not a mean over the time since the
// frame before.
#pragma once

#include <map>
#include <string>

#include "scene/scene.h"

namespace saccade {

// `definitions` override the file's <default> values ($name). Relative file names are looked up in the folder
// of the scene file. Throws SceneError.
Scene loadMitsubaXml(const std::string& path, const std::map<std::string, std::string>& definitions = {});

}  // namespace saccade
