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
  vertices_ += vertices * (1 + part.count("targets"));
  corners_ += indices ? accessorCount(root_, *indices) : vertices;
  if (std::max(vertices_, corners_) > 3 * kMaxTriangles)
    throw part.error("the scene has more than " + std::to_string(kMaxTriangles) + " triangles");
}

void GltfMeshes::add(const GltfNode& node, const Placed& placed) {
  const auto index = node.json.index("mesh", root_.count("meshes"));
  if (!index) return;
  const JsonNode mesh = root_.entry("meshes", *index);
  for (const JsonNode& part : mesh.list("primitives")) {
    if (hasTriangles(part))
      addPart(part, placed);
    else
      scene_.unread.push_back("points and lines of " + placed.name + " are not shown");
  }
}

void GltfMeshes::addPart(const JsonNode& part, Placed placed) {
  count(part);
  const bool coded = part.extension("KHR_draco_mesh_compression").has_value();
  if (placed.form && coded && part.count("targets") > 0) {
    scene_.unread.push_back(placed.name +
                            " keeps its form: it has morph targets, and is compressed with Draco");
    placed.form.reset();
  }
  const int material = materials_.read(part.index("material", root_.count("materials")));
  const std::size_t index = scene_.meshes.size();
  const BsdfKind kind = scene_.materials[static_cast<std::size_t>(material)].model.kind;
  if (part.at("attributes").find("COLOR_0") && (coded || kind != BsdfKind::kMetallicRoughness))
    scene_.unread.push_back("the colours of the vertices of " + placed.name + " are not shown");
  Mesh& outline = scene_.meshes.emplace_back();
  outline.name = placed.name, outline.material = material;
  if (placed.form && placed.form->changes) {
    outline.deformation = static_cast<int>(scene_.deformations.size());
    scene_.deformations.emplace_back();
  }
  loads_.add([part](const std::string& what) { return part.error(what); },
             [=, this] { load(part, placed, materials_.uvSets(material), scene_.meshes[index]); });
}

void GltfMeshes::load(const JsonNode& part, const Placed& placed, const UvSets& uv_sets,
                      Mesh& outline) const {
  Mesh mesh = readPrimitive(root_, *buffers_, part, uv_sets);
  if (placed.form) {
    Deformation deformation = forms_.place(*placed.form, part, placed.to_scene, mesh);
    if (outline.deformation != kKeepsForm)
      scene_.deformations[static_cast<std::size_t>(outline.deformation)] = std::move(deformation);
  } else {
    placeMesh(mesh, placed.to_scene, mesh.normals.empty());
  }
  if (!isFinite(mesh)) throw SceneError("a vertex is too far away for float numbers");
  mesh.name = outline.name, mesh.material = outline.material, mesh.deformation = outline.deformation;
  outline = std::move(mesh);
}

}  // namespace saccade
