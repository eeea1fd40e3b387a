#include <cmath>
#include <numbers>

#include "render/features/features.h"

namespace saccade {
namespace {

// The mean over the sphere. A row of pixels covers cos(theta) from its upper edge to its lower one.
Rgb meanOf(const Picture& picture) {
  Vec3d sum;
  const auto edge = [&](int row) { return std::cos(std::numbers::pi * row / picture.height); };
  for (int y = 0; y < picture.height; ++y) {
    Vec3d row;
    for (int x = 0; x < picture.width; ++x)
      row = row + toDouble(picture.pixels[static_cast<std::size_t>(y * picture.width + x)]);
    sum = sum + row * ((edge(y) - edge(y + 1)) / 2 / picture.width);
  }
  return toFloat(sum);
}

}  // namespace

bool hasEnvironmentPicture(const Scene& scene) {
  return scene.environment && !scene.environment->picture.pixels.empty();
}

void leaveOutEnvironmentPicture(Scene& scene) {
  if (!hasEnvironmentPicture(scene)) return;
  scene.environment =
      Environment{.radiance = scene.environment->radiance * meanOf(scene.environment->picture),
                  .picture = {},
                  .to_world = {}};
}

}  // namespace saccade
