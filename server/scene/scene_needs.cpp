#include "scene/scene_needs.h"

#include <cmath>
#include <vector>

#include "scene/files/text.h"

namespace saccade {
namespace {

template <class T>
std::size_t bytesOf(const std::vector<T>& values) {
  return values.size() * sizeof(T);
}

void addMesh(const Mesh& mesh, SceneNeeds& needs) {
  needs.triangles += mesh.triangles.size();
  needs.geometry_bytes +=
      bytesOf(mesh.positions) + bytesOf(mesh.normals) + bytesOf(mesh.uvs) + bytesOf(mesh.triangles);
  if (mesh.radiance != Rgb{}) ++needs.area_lights;
}

void addMaterial(const Material& material, SceneNeeds& needs) {
  ++needs.materials[material.model.kind];
  if (!isOpaque(material)) ++needs.masks;
  if (isBumpy(material)) ++needs.bump_maps;
}

// "3 spheres", or nothing of none.
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

SceneNeeds needsOf(const Scene& scene) {
  SceneNeeds needs;
  needs.meshes = scene.meshes.size(), needs.spheres = scene.spheres.size();
  needs.geometry_bytes = bytesOf(scene.spheres);
  for (const Mesh& mesh : scene.meshes) addMesh(mesh, needs);
  for (const Sphere& sphere : scene.spheres) needs.area_lights += sphere.radiance != Rgb{};
  for (const Material& material : scene.materials) addMaterial(material, needs);
  needs.environments = scene.environment.has_value();
  needs.point_lights = static_cast<int>(scene.point_lights.size());
  needs.directional_lights = static_cast<int>(scene.directional_lights.size());
  needs.textures = scene.textures.size();
  for (const Texture& texture : scene.textures) needs.texture_bytes += texture.bytes();
  if (scene.environment) needs.texture_bytes += bytesOf(scene.environment->picture.pixels);
  needs.channels = colorChannels(scene);
  return needs;
}

double SceneNeeds::bytesPerTriangle() const {
  return triangles == 0 ? 0 : static_cast<double>(geometry_bytes) / static_cast<double>(triangles);
}

std::string SceneNeeds::text() const {
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
  addCount(parts, static_cast<std::size_t>(directional_lights), "directional light");
  addCount(parts, textures, "texture");
  addCount(parts, static_cast<std::size_t>(channels), "channel");
  return joinNames(parts) + "; geometry " + mebibytes(geometry_bytes) + " (" +
         std::to_string(std::lround(bytesPerTriangle())) + " bytes per triangle), textures " +
         mebibytes(texture_bytes);
}

}  // namespace saccade
