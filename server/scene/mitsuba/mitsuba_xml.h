// Reads a Mitsuba scene file of either dialect: 0.4 to 0.6 (toWorld, intIOR) or 3 (to_world, int_ior). Names
// of both are read in all files; where defaults differ, the version of the scene decides.
//
// Supported:
//   sensor    perspective, the first of several: fov along x, or fov_axis y|x|smaller|larger|diagonal, or
//             focal_length, by default 50mm; one that mirrors is taken unmirrored, with a warning
//   shape     obj, ply (flip_tex_coords), serialized (shape_index), rectangle, cube, disk, cylinder, sphere;
//             face_normals and max_smooth_angle of meshes in files, flip_normals
//   bsdf      the kinds of bsdf_model.h, and roughdiffuse as diffuse; around one, in any order, twosided,
//             mask, bumpmap; coats (mitsuba_coat.h); blends of diffuse ones, or with weights of 0 and 1
//   texture   bitmap (to_uv or uscale and the like; raw or gamma 1), checkerboard
//   emitter   area, of a shape; envmap, constant, point, spot, directional; sky, sun, sunsky (mitsuba_sky.h)
//   transform of matrix, translate, rotate, scale, lookat in order
//   <include filename="..."> of a <scene>, of which the children are read; <path value="FOLDER"> to look
//   files up in. Both are relative to the folder of the scene's file, also in an included file <default> and
//   $names, of which values.toml gives values (scene_values.h) ids and refs, in any order. Shapes may
//   share an id: they are one object
// Colours: see xml_color.h. Indices of refraction are numbers, or names of dielectrics.h. A bsdf at the top
// without an id goes by that of the bsdf within it. Of integrators max_depth is kept, and of the film its
// width and height. Samplers and the like are ignored. So are properties that change no light: strings, flags
// and numbers of the film, or a principal point of 0. Anything else, or beyond limits.h, is a SceneError that
// names file, line and what is supported.
//
// Our extension: an area emitter may change over stream time, by a factor (dimensionless, at least 0) on its
// radiance.
//   <string name="strength" value="0:1, 0.05:1, 0.05:0.2"/>   keys, seconds:factor, times never decreasing
//   <float name="strength_period" value="0.1"/>               seconds; with it, the keys repeat for ever
// It is linear between keys and held before the first and after the last. Two keys at one time switch; at
// that time the later one holds. Every frame shows the factor at its time, not a mean over the time since the
// frame before.
#pragma once

#include <string>

#include "scene/files/load_options.h"
#include "scene/scene.h"

namespace saccade {

// Files are looked up as findFile() says. Throws SceneError.
Scene loadMitsubaXml(const std::string& path, const LoadOptions& options = {});
// The same without reading any mesh or picture: meshes have names alone. Throws SceneError.
Scene outlineMitsubaXml(const std::string& path, const LoadOptions& options);
// The same of a text, as if it stood in a file at `path`.
Scene parseMitsubaXml(std::string text, const std::string& path, const LoadOptions& options = {});

}  // namespace saccade
