#include "scene/emission_pictures.h"

#include <map>

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

std::vector<Rgb> takeEmissionMeans(Scene& scene) {
  std::map<int, Rgb> of_textures;
  std::vector<Rgb> means;
  for (const Material& m : scene.materials) {
    means.push_back({1, 1, 1});
    if (!isTextured(m.emission)) continue;
    Texture& picture = scene.textures[static_cast<std::size_t>(m.emission.texture)];
    const auto [found, added] = of_textures.try_emplace(m.emission.texture, picture.mean());
    if (added) picture = scaled(picture, found->second);
    means.back() = found->second;
  }
  return means;
}

}  // namespace saccade
