#include "methods/baked_frames.h"

#include <utility>

namespace saccade {
namespace {

void addRow(const GridEstimate& from, int y, GridEstimate& to) {
  for (const auto plane : {&GridEstimate::i, &GridEstimate::var_i, &GridEstimate::var_step})
    for (int x = 0; x < to.i.width(); ++x) (to.*plane).at(x, y) += (from.*plane).at(x, y);
}

}  // namespace

BakedFrames::BakedFrames(std::shared_ptr<const BakedLight> light, int width, int height)
    : light_(std::move(light)), now_(width, height), prev_(width, height) {}

SurfaceGrid::Time BakedFrames::look(SurfaceSamples& on, const GBuffer& g, const PoolHandle& pool) {
  std::swap(now_, prev_);
  return light_->read(on, g, pool, now_);
}

SurfaceGrid::Time BakedFrames::add(const PoolHandle& pool, GridEstimate& now, GridEstimate& before) const {
  return pool.forEachRow(now.i.height(), [&](int y) {
    addRow(now_, y, now);
    addRow(prev_, y, before);
  });
}

}  // namespace saccade
