#include "methods/baked_frames.h"

#include <utility>

namespace saccade {

BakedFrames::BakedFrames(std::shared_ptr<const BakedLight> light, int width, int height)
    : light_(std::move(light)), now_(width, height), prev_(width, height) {}

SurfaceGrid::Time BakedFrames::look(const SurfaceSamples& on, const GBuffer& g, const PoolHandle& pool) {
  std::swap(now_, prev_);
  return light_->read(on, g, pool, now_.light, now_.known);
}

SurfaceGrid::Time BakedFrames::overwrite(const PoolHandle& pool, GridEstimate& now,
                                         GridEstimate& before) const {
  return pool.forEachRow(now_.known.height(), [&](int y) {
    now_.overwriteRow(y, now);
    prev_.overwriteRow(y, before);
  });
}

void BakedFrames::View::overwriteRow(int y, GridEstimate& out) const {
  for (int x = 0; x < known.width(); ++x) {
    if (known.at(x, y) == 0) continue;
    for (const auto plane : {&GridEstimate::i, &GridEstimate::var_i, &GridEstimate::var_step})
      (out.*plane).at(x, y) = (light.*plane).at(x, y);
  }
}

}  // namespace saccade
