#include "scene/gltf/gltf_materials.h"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "scene/emission_pictures.h"
#include "scene/gltf/two_sides.h"

namespace saccade {

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

void GltfMaterials::setEmission() {
  const std::vector<Rgb> means = takeEmissionMeans(scene_);
  std::vector<Mesh> backs;
  for (Mesh& mesh : scene_.meshes) {
    const GltfMaterial& of = read_[static_cast<std::size_t>(mesh.material)];
    mesh.radiance = of.emission * means[static_cast<std::size_t>(mesh.material)];
    if (of.emits_back && emits(mesh) && isOpen(mesh)) backs.push_back(backOf(mesh));
  }
  std::ranges::move(backs, std::back_inserter(scene_.meshes));
}

}  // namespace saccade
