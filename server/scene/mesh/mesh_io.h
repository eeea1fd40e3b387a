// Reads mesh files. The result is raw: in the space of the file, without a name, `positions` without the
// spare entry. `normals` and `uvs` are empty unless the file has them for every vertex. placeMesh() makes it
// part of a scene.
//
// All functions throw SceneError, which names the line or the face. Causes are malformed text, an index out
// of range, a number that is not finite, a mesh without triangles, or one beyond limits.h. Polygons become
// fans of triangles, so they should be convex. Faces of an OBJ file with one or two corners have no area, and
// are left out.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace saccade {

// Wavefront OBJ: v, vt, vn and f (v, v/vt, v//vn, v/vt/vn; negative indices count from the end). The whole
// file becomes one mesh: groups, objects and smoothing groups are ignored.
struct ObjFile {
  struct Use {
    std::size_t triangle;  // the first one that has the material
    std::string material;
  };
  Mesh mesh;
  std::vector<Use> uses = {};               // in the order of triangles; before the first they have none
  std::vector<std::string> libraries = {};  // files of materials
};
ObjFile loadObjFile(const std::string& path);
// The mesh alone; Mesh::unread tells of materials.
Mesh loadObj(const std::string& path);
Mesh parseObj(std::string_view bytes, const std::string& path);  // content of a file; `path` is for messages

// PLY 1.0, ascii or binary of either byte order. Vertices have x y z, nx ny nz, and u v or s t; faces have
// vertex_indices or vertex_index. Other properties and elements are ignored. Mesh::unread tells of colours.
Mesh loadPly(const std::string& path);
Mesh parsePly(std::string_view bytes, const std::string& path);

// A serialized file of Mitsuba 0.5 to 3, versions 3 and 4, of floats or doubles. It may hold several meshes,
// of which `index` counts from 0. No other mesh in it is read. Mesh::unread tells of colours.
Mesh loadSerialized(const std::string& path, int index);
Mesh parseSerialized(std::string_view bytes, const std::string& path, int index);

}  // namespace saccade
