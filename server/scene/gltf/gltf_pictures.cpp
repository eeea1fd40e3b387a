#include "scene/gltf/gltf_pictures.h"

#include <algorithm>
#include <cmath>

#include "base/single.h"
#include "base/text_cut.h"
#include "scene/gltf/gltf_uri.h"

namespace saccade {
namespace {

// Of OpenGL.
constexpr std::size_t kRepeat = 10497, kMirror = 33648, kClamp = 33071;

Texture::Wrap wrapOf(const JsonNode& sampler, const char* key) {
  switch (sampler.size(key, kRepeat)) {
    case kRepeat:
      return Texture::Wrap::kRepeat;
    case kMirror:
      return Texture::Wrap::kMirror;
    case kClamp:
      return Texture::Wrap::kClamp;
    default:
      throw sampler.error(std::string(key) + " is not 10497, 33648 or 33071");
  }
}

PixelUse pixelUse(PictureUse::Kind kind) {
  if (kind == PictureUse::Kind::kNumbers) return PixelUse::kRawReflectance;
  const bool alpha = kind == PictureUse::Kind::kCoverage || kind == PictureUse::Kind::kCutOut;
  return alpha ? PixelUse::kAlpha : PixelUse::kReflectance;
}

Texture loadFor(const PictureFile& source, const PictureUse& use) {
  Picture picture = loadPicture(source, pixelUse(use.kind));
  for (Rgb& c : picture.pixels) {
    c = c * use.factor;
    if (use.kind == PictureUse::Kind::kCutOut) c.x = c.y = c.z = c.x >= use.threshold ? 1 : 0;
  }
  Texture texture(picture.width, picture.height, std::move(picture.pixels));
  texture.setWrap(use.wrap_u, use.wrap_v);
  return texture;
}

// KHR_texture_transform: the coordinates are scaled, then turned by the angle, then moved. Those of glTF have
// v = 0 at the top of the picture, and ours at the bottom.
void setTransform(const JsonNode& info, SurfaceColor& c) {
  double angle = 0;
  std::array<double, 2> scale{1, 1}, offset{0, 0};
  if (const auto transform = info.extension("KHR_texture_transform")) {
    angle = transform->number("rotation", 0);
    scale = transform->numbers<2>("scale", scale), offset = transform->numbers<2>("offset", offset);
  }
  const double cosine = std::cos(angle), sine = std::sin(angle);
  c.uv_scale = {single(scale[0] * cosine), single(-scale[1] * cosine)};
  c.uv_cross = {single(scale[1] * sine), single(scale[0] * sine)};
  c.uv_offset = {single(offset[0]), single(1 - offset[1])};
}

}  // namespace

std::size_t GltfPictures::coordinates(const JsonNode& info) {
  const std::size_t own = info.size("texCoord", 0);
  const auto transform = info.extension("KHR_texture_transform");
  return transform ? transform->size("texCoord", own) : own;
}

SurfaceColor GltfPictures::read(const JsonNode& info, PictureUse use) {
  SurfaceColor c;
  c.kind = SurfaceColor::Kind::kBitmap;
  setTransform(info, c);
  const JsonNode root = file_.root();
  const JsonNode texture = root.entry("textures", info.at("index").index(root.count("textures")));
  if (const auto sampler = texture.index("sampler", root.count("samplers"))) {
    const JsonNode at = root.entry("samplers", *sampler);
    use.wrap_u = wrapOf(at, "wrapS"), use.wrap_v = wrapOf(at, "wrapT");
  }
  c.texture = add(imageOf(texture), use);
  return c;
}

JsonNode GltfPictures::imageOf(const JsonNode& texture) const {
  const JsonNode root = file_.root();
  const std::size_t images = root.count("images");
  const auto webp = texture.extension("EXT_texture_webp");
  const auto image = webp ? webp->index("source", images) : texture.index("source", images);
  if (!image) throw texture.error("has no source that is read; there are: PNG, JPEG, WebP");
  return root.entry("images", *image);
}

PictureFile GltfPictures::sourceOf(const JsonNode& image) {
  const auto uri = image.find("uri");
  if (uri && !isData(uri->text())) return file_.locate(*uri, uri->text());
  if (!uri && buffers_) return {buffers_->view(image.at("bufferView").size()).bytes, "the picture"};
  const auto [data, added] = data_.try_emplace(image.place());
  if (added && uri && buffers_) data->second = decodeData(*uri, uri->text());
  return {data->second, "the picture"};
}

int GltfPictures::add(const JsonNode& image, const PictureUse& use) {
  const auto [found, added] = added_.try_emplace(std::tuple_cat(std::tuple(image.place()), use.key()),
                                                 static_cast<int>(scene_.textures.size()));
  if (!added) return found->second;
  const auto index = static_cast<std::size_t>(found->second);
  scene_.textures.push_back(Texture(1, 1, {Rgb{}}));
  loads_.add([image](const std::string& what) { return image.error(what); },
             [&loads = loads_, &textures = scene_.textures, index, source = sourceOf(image), use] {
               loads.takePixels(countPixels(source));
               textures[index] = loadFor(source, use);
             });
  return found->second;
}

}  // namespace saccade
