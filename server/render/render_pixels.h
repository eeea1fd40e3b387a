// Renders some pixels of a frame.
#pragma once

#include "render/renderer.h"

namespace saccade {

// Does what Renderer::render() does, at the pixels where `wanted` is not 0. Other pixels stay as they are.
std::chrono::nanoseconds renderPixels(const RenderSettings& settings, const PixelContext& view,
                                      const SeedPlan& seeds, const Image<int>& wanted, const PoolHandle& pool,
                                      Frame& out);

}  // namespace saccade
