// Which pixels get more pairs, and what these add to the first ones.
#pragma once

#include <array>
#include <chrono>
#include <span>

#include "base/pool_handle.h"
#include "frame/frame.h"

namespace saccade {

// What the pairs of a frame have found.
struct PairedLight {
  ImageF& now;
  PairSamples& pairs;
  // Of both frames, where the light is that of whole pixels. Their changes are those of illumination.
  const GBuffer *g_now = nullptr, *g_before = nullptr;
};

// Estimates the variance of each pixel's pairs by those around it. Plans `more` pairs where the noise of its
// radiance is above the mean of the picture, as at the edge of a lamp's reflection [ours].
std::chrono::nanoseconds planMorePairs(const PairedLight& light, const PoolHandle& pool);

// Adds a pixel's further pairs to its means. Each is the reflected light now and before.
void addPairs(std::span<const std::array<float, 2>> further, int x, int y, const PairedLight& light);

}  // namespace saccade
