#include "scene/gltf/gltf_extensions.h"

#include <algorithm>

#include "base/names.h"
#include "base/text_cut.h"

namespace saccade {
namespace {

const std::vector<std::string>& supported() {
  static const std::vector<std::string> names{"EXT_meshopt_compression",
                                              "EXT_texture_webp",
                                              "KHR_draco_mesh_compression",
                                              "KHR_lights_punctual",
                                              "KHR_materials_emissive_strength",
                                              "KHR_materials_ior",
                                              "KHR_materials_specular",
                                              "KHR_materials_transmission",
                                              "KHR_materials_volume",
                                              "KHR_mesh_quantization",
                                              "KHR_texture_transform",
                                              "SACCADE_sky"};
  return names;
}

// Names the extensions of a list of the file that are not supported.
std::vector<std::string> unknown(const JsonNode& root, const char* list) {
  std::vector<std::string> names;
  for (const JsonNode& entry : root.list(list))
    if (std::ranges::find(supported(), entry.text()) == supported().end())
      names.push_back(cutText(entry.text(), kMaxEcho));
  return names;
}

}  // namespace

void requireExtensions(const JsonNode& root) {
  const std::vector<std::string> names = unknown(root, "extensionsRequired");
  if (!names.empty())
    throw root.error("requires the extensions " + cutText(joinNames(names), kMostNames) +
                     "; supported: " + joinNames(supported()));
}

std::vector<std::string> unreadExtensions(const JsonNode& root) {
  const std::vector<std::string> names = unknown(root, "extensionsUsed");
  if (names.empty()) return {};
  return {"not shown are the extensions " + cutText(joinNames(names), kMostNames)};
}

}  // namespace saccade
