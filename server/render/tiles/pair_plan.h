// Which pixels get more pairs, and what these add to the first ones.
#pragma once

#include <array>
#include <chrono>
#include <span>

#include "base/pool_handle.h"
#include "frame/frame.h"

namespace saccade {

// Estimates the variance of each pixel's pairs by those around it. Plans `more` pairs where the noise of its
// radiance is above the mean of the picture, as at the edge of a lamp's reflection [ours]. So it does where
// no pixel around has pairs that could tell it.
std::chrono::nanoseconds planMorePairs(const Frame& now, const Frame& before, const PoolHandle& pool,
                                       PairSamples& pairs);

// Adds a pixel's further pairs to its means. Each is the reflected light now and before. `g_now`,
// `g_before`: the features of both frames.
void addPairs(std::span<const std::array<float, 2>> further, int x, int y, const GBuffer& g_now,
              const GBuffer& g_before, FrameSamples& samples, PairSamples& pairs);

}  // namespace saccade
