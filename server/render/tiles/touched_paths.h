// The paths of a frame's points that may find other light in the world of the frame before [ours].
#pragma once

#include <cstdint>
#include <vector>

namespace saccade {

class TouchedPaths {
 public:
  // None, of points that have `most` paths each at most.
  void reset(std::size_t points, std::uint32_t most) {
    words_ = (most + kBits - 1) / kBits;
    bits_.assign(points * words_, 0), light_.assign(points, 0);
  }

  // A path of a point, and what it has found. Points may be told by different threads.
  void add(std::size_t point, std::uint32_t path, double light) {
    bits_[point * words_ + path / kBits] |= std::uint64_t{1} << path % kBits;
    light_[point] += light;
  }
  bool has(std::size_t point, std::uint32_t path) const {
    return bits_[point * words_ + path / kBits] >> path % kBits & 1;
  }
  // The light that those of a point have found, all together.
  double light(std::size_t point) const { return light_[point]; }

 private:
  static constexpr std::uint32_t kBits = 64;  // of a word

  std::size_t words_ = 0;            // of a point
  std::vector<std::uint64_t> bits_;  // of paths, by point
  std::vector<double> light_;        // by point
};

}  // namespace saccade
