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
    : light_(std::move(light)), of_{GridEstimate(width, height), GridEstimate(width, height)} {}

SurfaceGrid::Time BakedFrames::add(FrameIndex cur, const PoolHandle& pool, GridEstimate& now,
                                   GridEstimate& before) const {
  return pool.forEachRow(now.i.height(), [&](int y) {
    addRow(of_[cur % 2], y, now);
    addRow(of_[(cur + 1) % 2], y, before);
  });
}

}  // namespace saccade
