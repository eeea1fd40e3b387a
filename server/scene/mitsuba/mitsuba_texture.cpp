#include "scene/mitsuba/mitsuba_texture.h"

#include "base/single.h"
#include "scene/files/picture.h"
#include "scene/mitsuba/mitsuba_transform.h"

namespace saccade {
namespace {

// Reads to_uv, of scale and translate, or the uscale and the like of Mitsuba 0.6.
void readUvMap(const XmlFile& file, Properties& properties, SurfaceColor& c) {
  const pugi::xml_node node = properties.object("transform", "to_uv");
  const Affine map = parseTransform(file, node);
  if (map.x.y != 0 || map.x.z != 0 || map.y.x != 0 || map.y.z != 0)
    throw file.error(node, "to_uv supports scale and translate only");
  c.uv_scale = {single(properties.number("uscale", map.x.x)), single(properties.number("vscale", map.y.y))};
  c.uv_offset = {single(properties.number("uoffset", map.translation.x)),
                 single(properties.number("voffset", map.translation.y))};
}

// Gamma 1 means linear; -1, the default, leaves it to the file.
bool readRaw(const XmlFile& file, pugi::xml_node bitmap, Properties& properties) {
  const double gamma = properties.number("gamma", -1);
  if (gamma != 1 && gamma != -1)
    throw file.error(bitmap, "a gamma of " + std::to_string(gamma) + " is not supported; supported: 1, -1");
  return properties.flag("raw", gamma == 1);
}

void requireRepeat(const XmlFile& file, pugi::xml_node bitmap, Properties& properties) {
  for (const char* name : {"wrap_mode", "wrap_mode_u", "wrap_mode_v"})
    if (const std::string mode = properties.text(name); !mode.empty() && mode != "repeat")
      throw file.error(bitmap,
                       "the " + std::string(name) + " '" + mode + "' is not supported; supported: repeat");
}

PixelUse pixelUse(TextureReader::Use use, bool raw) {
  if (use == TextureReader::Use::kOpacity) return raw ? PixelUse::kRawOpacity : PixelUse::kOpacity;
  if (use == TextureReader::Use::kRadiance) return raw ? PixelUse::kRawRadiance : PixelUse::kRadiance;
  return raw ? PixelUse::kRawReflectance : PixelUse::kReflectance;
}

}  // namespace

SurfaceColor TextureReader::readColor(Properties& properties, const std::string& name,
                                      const SurfaceColor& fallback, Use use) {
  if (const pugi::xml_node texture = properties.object("texture", name)) return readTexture(texture, use);
  const std::optional<Rgb> color = properties.share(name);
  return color ? constantColor(*color) : fallback;
}

SurfaceColor TextureReader::readTexture(pugi::xml_node texture, Use use) {
  static const std::vector<std::string> all{"bitmap", "checkerboard"}, of_radiance{"bitmap"};
  const std::string type = supportedType(file_, texture, use == Use::kRadiance ? of_radiance : all);
  Properties properties(file_, texture);
  SurfaceColor c;
  if (type == "bitmap") {
    c = readBitmap(texture, properties, use);
  } else {
    c.kind = SurfaceColor::Kind::kCheckerboard;
    readUvMap(file_, properties, c);
    c.color0 = properties.share("color0").value_or(Rgb{0.4f, 0.4f, 0.4f});
    c.color1 = properties.share("color1").value_or(Rgb{0.2f, 0.2f, 0.2f});
  }
  properties.finish();
  return c;
}

SurfaceColor TextureReader::readBitmap(pugi::xml_node bitmap, Properties& properties, Use use) {
  SurfaceColor c;
  c.kind = SurfaceColor::Kind::kBitmap;
  readUvMap(file_, properties, c);
  // Mitsuba's v = 0 is the top of a picture, and ours the bottom.
  c.uv_scale.y = -c.uv_scale.y;
  c.uv_offset.y = 1 - c.uv_offset.y;
  const bool raw = readRaw(file_, bitmap, properties);
  requireRepeat(file_, bitmap, properties);
  properties.ignore("string", {"filter_type"});  // ours is always trilinear
  properties.ignore("float", {"max_anisotropy"});
  properties.ignore("boolean", {"cache"});
  c.texture = addPicture(bitmap, file_.locate(bitmap, properties.text("filename")), pixelUse(use, raw));
  return c;
}

int TextureReader::addPicture(pugi::xml_node at, const std::string& path, PixelUse use) {
  const std::size_t next = scene_.textures.size();
  const auto [found, added] = pictures_.try_emplace({path, use}, static_cast<int>(next));
  if (!added) return found->second;
  scene_.textures.push_back(Texture(1, 1, {Rgb{}}));
  loads_.add(file_.errorsAt(at), [&loads = loads_, &textures = scene_.textures, next, path, use] {
    loads.takePixels(countPixels(path));
    textures[next] = loadTexture(path, use);
  });
  return found->second;
}

}  // namespace saccade
