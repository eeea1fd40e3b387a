#include "scene/scene_stats.h"

#include <cmath>
#include <vector>

#include "base/names.h"

namespace saccade {
namespace {

template <class T>
std::size_t bytesOf(const std::vector<T>& values) {
  return values.size() * sizeof(T);
}

// Without the meshes that deform.
std::size_t bytesOfDeformations(const Scene& scene) {
  std::size_t bytes = 0;
  for (const Deformation& deformation : scene.deformations) bytes += saccade::bytesOf(deformation);
  for (const MovingNode& node : scene.nodes)
    for (const NodeTrack& track : node.tracks)
      bytes += bytesOf(track.keys.times) + bytesOf(track.keys.values);
  return bytes;
}

void addMesh(const Mesh& mesh, SceneStats& stats) {
  stats.triangles += mesh.triangles.size();
  stats.geometry_bytes += bytesOf(mesh.positions) + bytesOf(mesh.normals) + bytesOf(mesh.uvs) +
                          bytesOf(mesh.second_uvs) + bytesOf(mesh.colors) + bytesOf(mesh.triangles);
  if (mesh.radiance != Rgb{}) ++stats.area_lights;
}

void addMaterial(const Material& material, SceneStats& stats) {
  ++stats.materials[material.model.kind];
  if (!isOpaque(material)) ++stats.masks;
  if (isBumpy(material)) ++stats.bump_maps;
}

// "3 spheres", or empty for none.
void addCount(std::vector<std::string>& parts, std::size_t count, const std::string& one,
              const std::string& many) {
  if (count > 0) parts.push_back(std::to_string(count) + " " + (count == 1 ? one : many));
}
void addCount(std::vector<std::string>& parts, std::size_t count, const std::string& one) {
  addCount(parts, count, one, one + "s");
}

std::string mebibytes(std::size_t bytes) {
  const auto tenths = std::lround(static_cast<double>(bytes) / (1 << 20) * 10);
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " MiB";
}

}  // namespace

SceneStats statsOf(const Scene& scene) {
  SceneStats stats;
  stats.meshes = scene.meshes.size(), stats.spheres = scene.spheres.size();
  stats.geometry_bytes = bytesOf(scene.spheres);
  for (const Mesh& mesh : scene.meshes) addMesh(mesh, stats);
  stats.geometry_bytes += bytesOfDeformations(scene);
  for (const Sphere& sphere : scene.spheres) stats.area_lights += sphere.radiance != Rgb{};
  for (const Material& material : scene.materials) addMaterial(material, stats);
  stats.environments = scene.environment.has_value();
  stats.point_lights = static_cast<int>(scene.point_lights.size());
  stats.spot_lights = static_cast<int>(scene.spot_lights.size());
  stats.directional_lights = static_cast<int>(scene.directional_lights.size());
  stats.textures = scene.textures.size();
  for (const Texture& texture : scene.textures) stats.texture_bytes += texture.bytes();
  if (scene.environment) stats.texture_bytes += bytesOf(scene.environment->picture.pixels);
  stats.channels = colorChannels(scene);
  return stats;
}

double SceneStats::bytesPerTriangle() const {
  return triangles == 0 ? 0 : static_cast<double>(geometry_bytes) / static_cast<double>(triangles);
}

std::string SceneStats::text() const {
  std::vector<std::string> parts;
  addCount(parts, triangles, "triangle");
  addCount(parts, meshes, "mesh", "meshes");
  addCount(parts, spheres, "sphere");
  for (const auto& [kind, count] : materials)
    parts.push_back(std::to_string(count) + " " + traitsOf(kind).name);
  addCount(parts, static_cast<std::size_t>(masks), "mask");
  addCount(parts, static_cast<std::size_t>(bump_maps), "bump map");
  addCount(parts, static_cast<std::size_t>(area_lights), "area light");
  addCount(parts, static_cast<std::size_t>(environments), "environment");
  addCount(parts, static_cast<std::size_t>(point_lights), "point light");
  addCount(parts, static_cast<std::size_t>(spot_lights), "spot light");
  addCount(parts, static_cast<std::size_t>(directional_lights), "directional light");
  addCount(parts, textures, "texture");
  addCount(parts, static_cast<std::size_t>(channels), "channel");
  return joinNames(parts) + "; geometry " + mebibytes(geometry_bytes) + " (" +
         std::to_string(std::lround(bytesPerTriangle())) + " bytes per triangle), textures " +
         mebibytes(texture_bytes);
}

}  // namespace saccade
