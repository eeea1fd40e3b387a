#include "scene/mitsuba/mitsuba_material.h"

#include <set>

#include "scene/files/limits.h"
#include "scene/mitsuba/mitsuba_bsdf.h"
#include "scene/mitsuba/mitsuba_coat.h"

namespace saccade {
namespace {

Material defaultMaterial() {
  Material grey;
  grey.name = "default";
  grey.reflectance = constantColor({0.5f, 0.5f, 0.5f});
  return grey;
}

std::vector<std::string> allTypes() {
  std::vector<std::string> types = bsdfTypes();  // coating among them
  types.insert(types.end(), {"roughcoating", "twosided", "mask", "bumpmap", "blendbsdf", "mixturebsdf"});
  return types;
}

bool isWrapper(const std::string& type) {
  return type == "twosided" || type == "mask" || type == "bumpmap" || isCoat(type);
}
bool isBlend(const std::string& type) {
  return type == "blendbsdf" || type == "mixturebsdf";
}

// The shares of the bsdfs within a blend.
std::vector<double> blendWeights(const XmlFile& file, pugi::xml_node bsdf, Properties& properties) {
  if (std::string_view(bsdf.attribute("type").value()) == "blendbsdf") {
    const double second = properties.number("weight", 0.5);
    return {1 - second, second};
  }
  return parseNumbers(file, bsdf, properties.text("weights"));
}

bool isPlainDiffuse(const Material& m) {
  return m.model.kind == BsdfKind::kDiffuse && !isTextured(m) && isOpaque(m);
}

}  // namespace

int MaterialReader::read(pugi::xml_node bsdf) {
  if (const auto found = materials_.find(bsdf); found != materials_.end()) return found->second;
  scene_.materials.push_back(bsdf ? parse(bsdf) : defaultMaterial());
  return materials_[bsdf] = static_cast<int>(scene_.materials.size()) - 1;
}

int MaterialReader::addEmitting(int material, const SurfaceColor& emission) {
  Material copy = scene_.materials[static_cast<std::size_t>(material)];
  copy.emission = emission;
  scene_.materials.push_back(std::move(copy));
  return static_cast<int>(scene_.materials.size()) - 1;
}

// Reads a BSDF and the wrappers around it, in any order.
Material MaterialReader::parse(pugi::xml_node bsdf, Blends blends) {
  static const std::vector<std::string> types = allTypes();
  Material material;
  std::set<std::string> wrappers;
  pugi::xml_node coat;  // which is read after what it lies on
  for (int depth = 0; depth < kMaxBsdfDepth; ++depth) {
    if (material.name.empty()) material.name = bsdf.attribute("id").value();
    const std::string type = supportedType(file_, bsdf, types);
    if (isBlend(type)) {
      if (blends == Blends::kRefused) throw file_.error(bsdf, "a blend within a blend is not supported");
      bsdf = readBlend(type, bsdf, material);
      if (bsdf) continue;
    } else if (!isWrapper(type)) {
      readBsdf({file_, bsdf, textures_, scene_.unread}, material);
    }
    if (!isWrapper(type)) {
      if (material.name.empty()) material.name = type;
      if (coat) readCoat({file_, coat, textures_, scene_.unread}, material);
      return material;
    }
    if (!wrappers.insert(type).second && type != "twosided")
      throw file_.error(bsdf, "a " + type + " within a " + type + " is not supported");
    if (coat && type != "twosided")
      throw file_.error(bsdf, "a " + type + " below a coat is not supported; supported: around it");
    if (isCoat(type)) coat = bsdf;
    bsdf = readWrapper(type, bsdf, material);
  }
  throw file_.error(bsdf, "the bsdfs are nested more than " + std::to_string(kMaxBsdfDepth) + " deep");
}

// A weight of 1 leaves one bsdf, which is returned. Else diffuse surfaces have the sum of their shares, and
// none is left to read.
pugi::xml_node MaterialReader::readBlend(const std::string& type, pugi::xml_node bsdf, Material& material) {
  Properties properties(file_, bsdf);
  const std::vector<double> weights = blendWeights(file_, bsdf, properties);
  const std::vector<pugi::xml_node> parts = properties.objects("bsdf");
  properties.finish();
  if (parts.size() != weights.size())
    throw file_.error(bsdf, "has " + std::to_string(parts.size()) + " bsdfs for " +
                                std::to_string(weights.size()) + " weights");
  Rgb sum;
  double rest = 1 + 1e-6;
  std::optional<bool> twosided;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    rest -= weights[i];
    if (!(weights[i] >= 0 && rest >= 0))
      throw file_.error(bsdf, "the weights of a " + type + " must be at least 0, and their sum at most 1");
    if (weights[i] == 1) return parts[i];
    const Material part = parse(parts[i], Blends::kRefused);
    if (weights[i] == 0) continue;
    if (!isPlainDiffuse(part) || part.twosided != twosided.value_or(part.twosided))
      throw file_.error(
          parts[i],
          "other bsdfs than diffuse ones of one colour, with two sides all or none, are blended "
          "with weights of 0 and 1 alone");
    sum = sum + part.reflectance.color0 * static_cast<float>(weights[i]);
    twosided = part.twosided;
  }
  material.twosided = material.twosided || twosided.value_or(false);
  material.reflectance = constantColor(sum);
  return {};
}

// Returns the bsdf within the wrapper.
pugi::xml_node MaterialReader::readWrapper(const std::string& type, pugi::xml_node bsdf, Material& material) {
  Properties properties(file_, bsdf);
  if (type == "twosided") {
    material.twosided = true;
  } else if (type == "mask") {
    material.opacity = textures_.readColor(properties, "opacity", constantColor({0.5f, 0.5f, 0.5f}),
                                           TextureReader::Use::kOpacity);
  } else if (type == "bumpmap") {
    const pugi::xml_node height = properties.object("texture");
    if (!height) throw file_.error(bsdf, "a bumpmap needs a <texture>");
    material.height = textures_.readTexture(height);
    material.height_scale = static_cast<float>(properties.number("scale", 1));
  }
  const pugi::xml_node inner = properties.object("bsdf");
  if (!isCoat(type)) properties.finish();
  if (!inner) throw file_.error(bsdf, "a " + type + " bsdf needs a <bsdf> in it");
  return inner;
}

}  // namespace saccade
