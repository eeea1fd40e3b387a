#include "scene/mitsuba/mitsuba_material.h"

#include <set>

#include "scene/files/limits.h"
#include "scene/mitsuba/mitsuba_bsdf.h"

namespace saccade {
namespace {

Material defaultMaterial() {
  Material grey;
  grey.name = "default";
  grey.reflectance = constantColor({0.5f, 0.5f, 0.5f});
  return grey;
}

std::vector<std::string> allTypes() {
  std::vector<std::string> types = bsdfTypes();
  types.insert(types.end(), {"twosided", "mask", "bumpmap"});
  return types;
}

}  // namespace

int MaterialReader::read(pugi::xml_node bsdf) {
  if (const auto found = materials_.find(bsdf); found != materials_.end()) return found->second;
  scene_.materials.push_back(bsdf ? parse(bsdf) : defaultMaterial());
  return materials_[bsdf] = static_cast<int>(scene_.materials.size()) - 1;
}

// Reads a BSDF and the wrappers around it, in any order.
Material MaterialReader::parse(pugi::xml_node bsdf) {
  static const std::vector<std::string> types = allTypes();
  Material material;
  std::set<std::string> wrappers;
  for (int depth = 0; depth < kMaxBsdfDepth; ++depth) {
    if (material.name.empty()) material.name = bsdf.attribute("id").value();
    const std::string type = supportedType(file_, bsdf, types);
    if (type != "twosided" && type != "mask" && type != "bumpmap") {
      readBsdf(file_, bsdf, textures_, material);
      if (material.name.empty()) material.name = type;
      return material;
    }
    if (!wrappers.insert(type).second && type != "twosided")
      throw file_.error(bsdf, "a " + type + " within a " + type + " is not supported");
    bsdf = readWrapper(type, bsdf, material);
  }
  throw file_.error(bsdf, "the bsdfs are nested more than " + std::to_string(kMaxBsdfDepth) + " deep");
}

// Returns the bsdf within the wrapper.
pugi::xml_node MaterialReader::readWrapper(const std::string& type, pugi::xml_node bsdf, Material& material) {
  Properties properties(file_, bsdf);
  if (type == "twosided") {
    material.twosided = true;
  } else if (type == "mask") {
    material.opacity = textures_.readColor(properties, "opacity", constantColor({0.5f, 0.5f, 0.5f}),
                                           TextureReader::Use::kOpacity);
  } else {
    const pugi::xml_node height = properties.object("texture");
    if (!height) throw file_.error(bsdf, "a bumpmap needs a <texture>");
    material.height = textures_.readTexture(height);
    material.height_scale = static_cast<float>(properties.number("scale", 1));
  }
  const pugi::xml_node inner = properties.object("bsdf");
  properties.finish();
  if (!inner) throw file_.error(bsdf, "a " + type + " bsdf needs a <bsdf> in it");
  return inner;
}

}  // namespace saccade
