// Mesh files. What they give is in the space of the file and raw: `positions` without the spare entry,
// `normals` and `uvs` empty unless the file has them for every vertex; placeMesh() makes it part of a scene.
//
// All throw SceneError: naming the line (or the face) for what is malformed, an index out of range, a number
// that is not finite, a mesh without triangles or beyond limits.h. Polygons become fans of triangles, so they
// should be convex.
#pragma once

#include <string>
#include <string_view>

#include "scene/scene.h"

namespace saccade {

// Wavefront OBJ: v, vt, vn and f (v, v/vt, v//vn, v/vt/vn; negative indices count from the end). One mesh
// comes of the whole file: groups, objects, smoothing groups, materials and mtllib are read past.
Mesh loadObj(const std::string& path);
Mesh parseObj(std::string_view bytes, const std::string& path);  // what a file holds; `path` is for messages

// PLY 1.0, ascii or binary of either byte order: vertices with x y z, nx ny nz, and u v or s t; faces with
// vertex_indices or vertex_index. Other properties and elements are read past.
Mesh loadPly(const std::string& path);
Mesh parsePly(std::string_view bytes, const std::string& path);

}  // namespace saccade
