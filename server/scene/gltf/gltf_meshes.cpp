#include "scene/gltf/gltf_meshes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "scene/files/limits.h"
#include "scene/gltf/gltf_accessor.h"
#include "scene/gltf/gltf_primitive.h"
#include "scene/mesh/mesh.h"

namespace saccade {
namespace {

bool isFinite(const Mesh& mesh) {
  return std::ranges::all_of(mesh.positions, [](Vec3 p) { return std::isfinite(dot(p, p)); });
}

}  // namespace

// Before memory is taken: parts may share accessors, and nodes may share meshes.
void GltfMeshes::count(const JsonNode& part) {
  const std::size_t accessors = root_.count("accessors");
  const std::size_t vertices = accessorCount(root_, part.at("attributes").at("POSITION").index(accessors));
  const auto indices = part.index("indices", accessors);
  vertices_ += vertices;
  corners_ += indices ? accessorCount(root_, *indices) : vertices;
  if (std::max(vertices_, corners_) > 3 * kMaxTriangles)
    throw part.error("the scene has more than " + std::to_string(kMaxTriangles) + " triangles");
}

void GltfMeshes::add(const GltfNode& node, const std::string& name, const Affine& to_world) {
  const auto index = node.json.index("mesh", root_.count("meshes"));
  if (!index) return;
  const JsonNode mesh = root_.entry("meshes", *index);
  for (const JsonNode& part : mesh.list("primitives")) {
    if (hasTriangles(part))
      addPart(part, name, to_world);
    else
      scene_.unread.push_back("points and lines of " + name + " are not shown");
    if (part.find("targets"))
      scene_.unread.push_back("the shape of " + name + " stays without its morph targets");
  }
  if (node.json.find("skin")) scene_.unread.push_back("the skin of " + name + " stays at its first pose");
}

void GltfMeshes::addPart(const JsonNode& part, const std::string& name, const Affine& to_world) {
  count(part);
  const int material = materials_.read(part.index("material", root_.count("materials")));
  const std::size_t coordinates = materials_.coordinates(material), index = scene_.meshes.size();
  if (part.at("attributes").find("COLOR_0"))
    scene_.unread.push_back("the colours of the vertices of " + name + " are not shown");
  Mesh& outline = scene_.meshes.emplace_back();
  outline.name = name, outline.material = material;
  loads_.add([part](const std::string& what) { return part.error(what); },
             [=, this, &meshes = scene_.meshes] {
               Mesh mesh = readPrimitive(root_, *buffers_, part, coordinates);
               placeMesh(mesh, to_world, mesh.normals.empty());
               if (!isFinite(mesh)) throw SceneError("a vertex is too far away for float numbers");
               mesh.name = name, mesh.material = material;
               meshes[index] = std::move(mesh);
             });
}

}  // namespace saccade
