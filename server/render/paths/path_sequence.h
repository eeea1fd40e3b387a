// The random numbers of the first vertices of paths whose samples are averaged over neighbours and frames.
// They are spread evenly over any few of these. So the mean of n such samples has less noise than that of n
// random ones [ours].
//
// A number is a sum of whole multiples of irrational steps: one for each column, row, path of a pixel and
// frame. Each dimension has a random start (Cranley and Patterson 1976). Steps of frames are the R sequences
// of Roberts (2018), the others fractions of square roots of primes. After kRunFrames frames there is a new
// start: otherwise errors that a moving camera keeps would never average out.
#pragma once

#include <array>

#include "render/paths/tracing.h"
#include "render/sampling/path_numbers.h"
#include "render/sampling/path_sampler.h"

namespace saccade {

// The lower part of a path's key holds its place: column, row, number among the paths of its pixel, and frame
// within the run. The upper part is that of the run, and of what does not fit the place.
class SequencePlace {
 public:
  static constexpr int kEdgeBits = 11, kPathBits = 8, kFrameBits = 2;
  static constexpr int kY = kEdgeBits, kPath = kY + kEdgeBits,
                       kFrame = kPath + kPathBits;  // their first bits
  static_assert(kFrame + kFrameBits == 32);
  static constexpr std::uint32_t kRunFrames = 1u << kFrameBits;

  // `stream`: the seed of all frames.
  SequencePlace(std::uint64_t stream, std::uint64_t frame)
      : run_(hashKey(stream, frame / kRunFrames)), frame_(static_cast<std::uint32_t>(frame % kRunFrames)) {}

  PathSampler of(std::uint32_t x, std::uint32_t y, std::uint32_t path) const {
    const std::uint64_t beyond =
        x >> kEdgeBits | std::uint64_t{y >> kEdgeBits} << 16 | std::uint64_t{path >> kPathBits} << 32;
    return {part(x, kEdgeBits, 0) | part(y, kEdgeBits, kY) | part(path, kPathBits, kPath) | frame_ << kFrame,
            static_cast<std::uint32_t>(hashKey(run_, beyond))};
  }

 private:
  static std::uint32_t part(std::uint32_t v, int bits, int first) {
    return (v & ((1u << bits) - 1)) << first;
  }

  std::uint64_t run_;
  std::uint32_t frame_;  // of the run
};

// By Dimension, as fractions of 2^32.
struct SequenceSteps {
  std::array<std::uint32_t, kDimensions> x, y, path, frame;
};
inline constexpr SequenceSteps kSequenceSteps = [] {
  const auto bits = [](std::array<double, kDimensions> fractions) {
    std::array<std::uint32_t, kDimensions> steps{};
    for (std::size_t i = 0; i < kDimensions; ++i)
      steps[i] = static_cast<std::uint32_t>(fractions[i] * 0x1p32);
    return steps;
  };
  static_assert(kLight == 0 && kBounce == 3 && kLobe == 5 && kDimensions == 6);
  return SequenceSteps{
      bits({0.4142135624, 0.7320508076, 0.2360679775, 0.6457513111, 0.3166247904, 0.2801098893}),
      bits({0.6055512755, 0.1231056256, 0.3588989435, 0.7958315233, 0.3851648071, 0.6811457478}),
      bits({0.5677643628, 0.0827625303, 0.4031242374, 0.5574385243, 0.8556546004, 0.8102496759}),
      bits({0.8191725134, 0.6710436067, 0.5497004779, 0.7548776662, 0.5698402910, 0.6180339887})};
}();

// Those of W paths, in [0, 1).
template <int W>
[[gnu::always_inline]] inline Floats<W> sequenceNumbers(const PathNumbers<W>& of, Dimension d) {
  using Place = SequencePlace;
  const auto part = [&](int first, int count) {
    return Uints<W>((of.reversed_index >> first) & ((1u << count) - 1));
  };
  const auto& steps = kSequenceSteps;
  const Uints<W> bits = mix32(Uints<W>(of.key + d * 0x9e3779b9u)) + part(0, Place::kEdgeBits) * steps.x[d] +
                        part(Place::kY, Place::kEdgeBits) * steps.y[d] +
                        part(Place::kPath, Place::kPathBits) * steps.path[d] +
                        (of.reversed_index >> Place::kFrame) * steps.frame[d];
  return PathNumbers<W>::unit(bits);
}

}  // namespace saccade
