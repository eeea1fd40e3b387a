#include "render/lights/lamp_picture.h"

#include <algorithm>
#include <cmath>

namespace saccade {

LampPicture::LampPicture(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle,
                         const SurfaceColor& factor)
    : radiance(mesh.radiance), color(factor) {
  const std::vector<Vec2>& uvs = factor.second_uvs ? mesh.second_uvs : mesh.uvs;
  if (uvs.empty()) return;
  const auto edge = [&](std::size_t k) {
    return Vec2{uvs[triangle[k]].x - corner.x, uvs[triangle[k]].y - corner.y};
  };
  corner = uvs[triangle[0]];
  edge1 = edge(1), edge2 = edge(2);
}

Rgb LampPicture::at(const std::vector<Texture>& textures, float u1, float u2) const {
  const float s = std::sqrt(u1), along1 = 1 - s, along2 = u2 * s;
  const Vec2 uv{corner.x + edge1.x * along1 + edge2.x * along2,
                corner.y + edge1.y * along1 + edge2.y * along2};
  return radiance * lookUp(textures, color, {uv, 0});
}

Rgb LampPicture::mean(const std::vector<Texture>& textures) const {
  constexpr int kSteps = 8;
  constexpr float kLeast = 0.01f;
  Rgb sum;
  for (int i = 0; i < kSteps; ++i)
    for (int j = 0; j < kSteps; ++j)
      sum = sum +
            at(textures, (static_cast<float>(i) + 0.5f) / kSteps, (static_cast<float>(j) + 0.5f) / kSteps);
  const Rgb mean = sum / static_cast<float>(kSteps * kSteps), least = radiance * kLeast;
  return {std::max(mean.x, least.x), std::max(mean.y, least.y), std::max(mean.z, least.z)};
}

}  // namespace saccade
