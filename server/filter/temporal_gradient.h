// Temporal gradients of light, which tell where a history is out of date. Schied, Peters and Dachsbacher
// 2018, "Gradient estimation for real-time adaptive temporal filtering" (A-SVGF).
//
// takes    frames of SeedPlan::correlatedAlongMotion: pass 1 has the points and the numbers that pass 2 had
//          one frame ago
// returns  lambda, the share of the light that has changed
//
// One pixel of each 3x3 stratum tells the change of light at its surface and the larger light of both frames:
//   delta = i_t - i_{t-1},   Delta = max(i_t, i_{t-1})
// Both are filtered over the strata, and lambda = min(1, |delta| / Delta).
#pragma once

#include <chrono>
#include <vector>

#include "base/pool_handle.h"
#include "frame/frame.h"

namespace saccade {

class TemporalGradient {
 public:
  TemporalGradient(int width, int height, int iterations);

  // Returns the CPU time over all threads.
  std::chrono::nanoseconds estimate(const FramePair& frames, const PoolHandle& pool);
  // lambda of a pixel, [0, 1]; 0 before the first estimate, and where no stratum around has a gradient.
  float change(int x, int y) const;

 private:
  static constexpr int kEdge = 3;  // of a stratum, pixels

  // The gradient of a stratum, and the features of the pixel that tells it.
  struct Gradient {
    float delta, larger;
    bool known;  // whether the pixel shows the same surface in both frames
  };
  struct Guide {
    float z, r_z, nx, ny, nz;
  };

  void sample(const FramePair& frames, int column, int row);
  Gradient filtered(int column, int row, int step) const;
  std::size_t indexOf(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }

  int width_, height_, columns_, rows_, iterations_;
  std::vector<Guide> guides_;
  std::vector<Gradient> gradients_, scratch_;
};

}  // namespace saccade
