#include "scene/gltf/gltf_primitive.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "scene/gltf/draco_mesh.h"

namespace saccade {
namespace {

// Of OpenGL.
enum Mode : std::size_t { kTriangles = 4, kStrip = 5, kFan = 6, kModes };

std::vector<Vec2> pairs(const std::vector<float>& v) {
  std::vector<Vec2> all(v.size() / 2);
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = {v[2 * i], v[2 * i + 1]};
  return all;
}

std::vector<std::uint32_t> corners(const JsonNode& root, const GltfBuffers& buffers, const JsonNode& part,
                                   std::size_t vertices) {
  if (const auto indices = part.index("indices", root.count("accessors")))
    return readIndices(root, buffers, *indices, vertices);
  std::vector<std::uint32_t> all(vertices);
  std::iota(all.begin(), all.end(), 0u);
  return all;
}

// Every second triangle of a strip begins with its later corner, so that all face alike [glTF 2.0, 3.7.2.1].
std::vector<std::array<std::uint32_t, 3>> triangles(const std::vector<std::uint32_t>& c, std::size_t mode) {
  std::vector<std::array<std::uint32_t, 3>> all;
  if (mode == kTriangles)
    for (std::size_t i = 0; i + 3 <= c.size(); i += 3) all.push_back({c[i], c[i + 1], c[i + 2]});
  for (std::size_t i = 0; mode == kStrip && i + 3 <= c.size(); ++i)
    all.push_back({c[i], c[i + 1 + i % 2], c[i + 2 - i % 2]});
  for (std::size_t i = 1; mode == kFan && i + 2 <= c.size(); ++i) all.push_back({c[i], c[i + 1], c[0]});
  return all;
}

// Their alpha does not count.
std::vector<Rgb> readColors(const JsonNode& root, const GltfBuffers& buffers, const JsonNode& attributes,
                            std::size_t vertices) {
  const auto index = attributes.index("COLOR_0", root.count("accessors"));
  if (!index) return {};
  const std::size_t numbers = root.entry("accessors", *index).text("type") == "VEC4" ? 4 : 3;
  const std::vector<float> v = readAttribute(root, buffers, attributes, "COLOR_0", numbers, vertices);
  std::vector<Rgb> colors(vertices);
  const auto part = [&](std::size_t i, std::size_t k) { return std::clamp(v[numbers * i + k], 0.f, 1.f); };
  for (std::size_t i = 0; i < vertices; ++i) colors[i] = {part(i, 0), part(i, 1), part(i, 2)};
  return colors;
}

}  // namespace

std::string texCoord(std::size_t set) {
  return "TEXCOORD_" + std::to_string(set);
}

bool hasTriangles(const JsonNode& part) {
  const std::size_t mode = part.size("mode", kTriangles);
  if (mode >= kModes) throw part.error("mode must be from 0 to 6");
  return mode >= kTriangles;
}

std::vector<float> readAttribute(const JsonNode& root, const GltfBuffers& buffers, const JsonNode& attributes,
                                 const std::string& name, std::size_t components, std::size_t vertices) {
  const auto index = attributes.index(name.c_str(), root.count("accessors"));
  if (!index) return {};
  std::vector<float> values = readFloats(root, buffers, *index, components);
  if (values.size() != components * vertices)
    throw attributes.error(name + " has " + std::to_string(values.size() / components) + " entries for " +
                           std::to_string(vertices) + " vertices");
  for (const float v : values)
    if (!std::isfinite(v)) throw attributes.error(name + " has a number that is not finite");
  return values;
}

std::vector<Vec3> readVectors(const JsonNode& root, const GltfBuffers& buffers, const JsonNode& attributes,
                              const std::string& name, std::size_t vertices) {
  const std::vector<float> v = readAttribute(root, buffers, attributes, name, 3, vertices);
  std::vector<Vec3> all(v.size() / 3);
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = {v[3 * i], v[3 * i + 1], v[3 * i + 2]};
  return all;
}

Mesh readPrimitive(const JsonNode& root, const GltfBuffers& buffers, const JsonNode& part,
                   const UvSets& uv_sets) {
  if (const auto coded = part.extension("KHR_draco_mesh_compression"))
    return DracoMesh(*coded, buffers).mesh(uv_sets);
  const std::size_t vertices =
      accessorCount(root, part.at("attributes").at("POSITION").index(root.count("accessors")));
  Mesh mesh;
  const JsonNode attributes = part.at("attributes");
  mesh.positions = readVectors(root, buffers, attributes, "POSITION", vertices);
  mesh.normals = readVectors(root, buffers, attributes, "NORMAL", vertices);
  const auto uvs = [&](std::size_t set) {
    return pairs(readAttribute(root, buffers, attributes, texCoord(set), 2, vertices));
  };
  mesh.uvs = uvs(uv_sets.first);
  if (uv_sets.second) mesh.second_uvs = uvs(*uv_sets.second);
  mesh.colors = readColors(root, buffers, attributes, vertices);
  mesh.triangles = triangles(corners(root, buffers, part, vertices), part.size("mode", kTriangles));
  if (mesh.triangles.empty()) throw part.error("has no triangle");
  return mesh;
}

}  // namespace saccade
