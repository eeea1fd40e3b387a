#include "scene/gltf/gltf_materials.h"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "scene/gltf/two_sides.h"

namespace saccade {
namespace {

// The picture over this mean.
Texture scaled(const Texture& picture, Rgb mean) {
  const auto over = [](float v, float m) { return m > 0 ? v / m : 0; };
  std::vector<Rgb> pixels = picture.pixels();
  for (Rgb& c : pixels) c = {over(c.x, mean.x), over(c.y, mean.y), over(c.z, mean.z)};
  Texture all(picture.width(), picture.height(), std::move(pixels));
  all.setWrap(picture.wrapU(), picture.wrapV());
  return all;
}

}  // namespace

int GltfMaterials::read(std::optional<std::size_t> i) {
  const auto [found, added] = index_.try_emplace(i, static_cast<int>(scene_.materials.size()));
  if (!added) return found->second;
  static const nlohmann::json kDefault = nlohmann::json::object();
  const JsonNode json = i ? root_.entry("materials", *i) : JsonNode(kDefault, root_.place());
  std::string name = i ? json.text("name") : "default";
  if (name.empty()) name = "material " + std::to_string(*i);
  GltfMaterial read = readMaterial(json, name, pictures_, scene_.unread);
  scene_.materials.push_back(std::move(read.material));
  read_.push_back(std::move(read));
  return found->second;
}

// The mean of the emission of each material. Its picture is divided by it.
std::vector<Rgb> GltfMaterials::takeMeans() {
  std::map<int, Rgb> of_textures;
  std::vector<Rgb> means;
  for (const Material& m : scene_.materials) {
    means.push_back({1, 1, 1});
    if (!isTextured(m.emission)) continue;
    Texture& picture = scene_.textures[static_cast<std::size_t>(m.emission.texture)];
    const auto [found, added] = of_textures.try_emplace(m.emission.texture, picture.mean());
    if (added) picture = scaled(picture, found->second);
    means.back() = found->second;
  }
  return means;
}

void GltfMaterials::setEmission() {
  const std::vector<Rgb> means = takeMeans();
  std::vector<Mesh> backs;
  for (Mesh& mesh : scene_.meshes) {
    const GltfMaterial& of = read_[static_cast<std::size_t>(mesh.material)];
    mesh.radiance = of.emission * means[static_cast<std::size_t>(mesh.material)];
    if (of.emits_back && emits(mesh) && isOpen(mesh)) backs.push_back(backOf(mesh));
  }
  std::ranges::move(backs, std::back_inserter(scene_.meshes));
}

}  // namespace saccade
