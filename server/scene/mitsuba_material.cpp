#include "scene/mitsuba_material.h"

#include "scene/mitsuba_transform.h"
#include "scene/xml_properties.h"

namespace saccade {
namespace {

// to_uv may scale and translate.
void parseToUv(const XmlFile& file, pugi::xml_node node, Reflectance& r) {
  const Affine map = parseTransform(file, node);
  if (map.x.y != 0 || map.x.z != 0 || map.y.x != 0 || map.y.z != 0)
    throw file.error(node, "to_uv supports scale and translate only");
  r.uv_scale = {static_cast<float>(map.x.x), static_cast<float>(map.y.y)};
  r.uv_offset = {static_cast<float>(map.translation.x), static_cast<float>(map.translation.y)};
}

constexpr Rgb grey(float v) {
  return {v, v, v};
}

Reflectance constant(Rgb color) {
  Reflectance r;
  r.color0 = color;
  return r;
}

}  // namespace

int MaterialReader::read(pugi::xml_node bsdf) {
  const auto [found, added] = materials_.try_emplace(bsdf, static_cast<int>(scene_.materials.size()));
  if (added)
    scene_.materials.push_back(bsdf ? parse(bsdf) : Material{"default", constant(grey(0.5f)), false});
  return found->second;
}

Material MaterialReader::parse(pugi::xml_node bsdf) {
  Material material{bsdf.attribute("id").value(), {}, false};
  while (supportedType(file_, bsdf, {"diffuse", "twosided"}) == "twosided") {
    material.twosided = true;
    Properties properties(file_, bsdf);
    const pugi::xml_node inner = properties.object("bsdf");
    properties.finish();
    if (!inner) throw file_.error(bsdf, "a twosided bsdf needs a <bsdf> in it");
    bsdf = inner;
    if (material.name.empty()) material.name = bsdf.attribute("id").value();
  }
  material.reflectance = parseReflectance(bsdf);
  return material;
}

Reflectance MaterialReader::parseReflectance(pugi::xml_node diffuse) {
  Properties properties(file_, diffuse);
  const auto color = properties.color("reflectance", 1);
  const pugi::xml_node texture = properties.object("texture", "reflectance");
  properties.finish();
  if (texture) return parseTexture(texture);
  return constant(color.value_or(grey(0.5f)));
}

Reflectance MaterialReader::parseTexture(pugi::xml_node texture) {
  const std::string type = supportedType(file_, texture, {"bitmap", "checkerboard"});
  Properties properties(file_, texture);
  Reflectance r;
  parseToUv(file_, properties.object("transform", "to_uv"), r);
  if (type == "checkerboard") {
    r.kind = Reflectance::Kind::kCheckerboard;
    r.color0 = properties.color("color0", 1).value_or(grey(0.4f));
    r.color1 = properties.color("color1", 1).value_or(grey(0.2f));
    properties.finish();
    return r;
  }
  r.kind = Reflectance::Kind::kBitmap;
  const std::string filename = properties.text("filename");
  const bool raw = properties.flag("raw", false);
  properties.readPast("string", "filter_type");  // ours is always trilinear
  properties.finish();
  r.texture = readBitmap(texture, filename, raw);
  return r;
}

int MaterialReader::readBitmap(pugi::xml_node at, const std::string& filename, bool raw) {
  if (filename.empty()) throw file_.error(at, "a bitmap needs <string name=\"filename\">");
  const auto [found, added] =
      textures_.try_emplace({file_.locate(filename), raw}, static_cast<int>(scene_.textures.size()));
  try {
    if (added) scene_.textures.push_back(loadTexture(found->first.first, raw));
  } catch (const SceneError& e) {
    throw file_.error(at, e.what());
  }
  return found->second;
}

}  // namespace saccade
