// The mean of a picture of a small scene.
#pragma once

#include <cmath>
#include <memory>
#include <utility>

#include "render/renderer.h"

namespace saccade::test {

// The view of the scene's own camera from where it stood before.
inline Frame renderFrame(Scene scene, const SeedPlan& seeds, RenderSettings settings, int size) {
  auto s = std::make_shared<RenderScene>(std::move(scene));
  TilePool pool(2);
  Frame frame(size, size);
  const Camera camera(s->description().T_world_camera, pinhole(s->description().fov_x_deg, size, size));
  const PosedScene posed(s);
  Renderer(settings).render(PixelContext({posed, camera}), seeds, pool, frame);
  return frame;
}
inline Frame renderFrame(Scene scene, int bounces, int spp, int size = 32, int channels = 1) {
  return renderFrame(std::move(scene), SeedPlan::independent(1, 0, spp), {bounces, channels}, size);
}

// Mean luminance and its standard error, from the spread of the pixels.
struct Mean {
  double mean, error;
};
inline Mean meanOf(const ImageF& image) {
  double sum = 0, square = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) sum += image.at(x, y), square += std::pow(image.at(x, y), 2);
  }
  const double n = image.width() * image.height(), mean = sum / n;
  return {mean, std::sqrt(std::max(0.0, square / n - mean * mean) / n)};
}
inline Mean renderMean(Scene scene, int bounces, int spp, int size = 32, int channels = 1) {
  return meanOf(renderFrame(std::move(scene), bounces, spp, size, channels).samples.I2);
}

}  // namespace saccade::test
