// Where the paths of a pass stand in one sequence of random numbers. Pixels follow each other in Morton's
// order (1966), and each has its samples one after another. So the samples of a pixel fill space evenly, and
// so do those of 2 x 2 pixels, of 4 x 4, and so on. Ahmed and Wonka 2020, "Screen-space blue-noise diffusion
// of Monte Carlo sampling error via hierarchical ordering of pixels".
#pragma once

#include <bit>

#include "frame/seed_plan.h"
#include "render/sampling/path_sampler.h"

namespace saccade {

class PixelSequence {
 public:
  // `samples`: of a pixel, in all.
  PixelSequence(std::uint64_t seed, int samples, NumberKind kind)
      : seed_(seed), sample_bits_(std::bit_width(static_cast<unsigned>(samples - 1))), kind_(kind) {}

  // Of a pixel whose column and row are below 2^16.
  PathSampler of(int x, int y, std::uint32_t sample) const {
    const auto column = static_cast<std::uint32_t>(x), row = static_cast<std::uint32_t>(y);
    if (kind_ == NumberKind::kIndependent) return {seed_, row << 16 | column, sample};
    const std::uint64_t index =
        std::uint64_t{everyOtherBit(column) | everyOtherBit(row) << 1} << sample_bits_ | sample;
    return {reverseBits(static_cast<std::uint32_t>(index)),
            static_cast<std::uint32_t>(hashKey(seed_, index >> 32))};
  }

 private:
  // Bit k becomes bit 2 k.
  static constexpr std::uint32_t everyOtherBit(std::uint32_t v) {
    v = (v | v << 8) & 0x00ff00ffu;
    v = (v | v << 4) & 0x0f0f0f0fu;
    v = (v | v << 2) & 0x33333333u;
    return (v | v << 1) & 0x55555555u;
  }

  std::uint64_t seed_;
  int sample_bits_;
  NumberKind kind_;
};

}  // namespace saccade
