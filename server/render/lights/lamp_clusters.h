// Groups of lamps that are close to each other and shine alike.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/lights/lamp_bounds.h"

namespace saccade {

struct LampCluster {
  std::span<std::uint32_t> lamps;  // numbers of lamps
  LampBounds bounds;
};

// Divides the lamps of `numbers` into at most `count` clusters, and orders them so. Each split is the one
// that leaves the least strength times size times spread [Conty Estevez and Kulla 2018].
std::vector<LampCluster> clustersOf(std::span<const LampBounds> lamps, std::span<std::uint32_t> numbers,
                                    std::size_t count);

}  // namespace saccade
