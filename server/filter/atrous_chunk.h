// A chunk of a row's pixels, as the taps of the a-trous filter read it.
#pragma once

#include "base/wide.h"
#include "filter/atrous.h"

namespace saccade {

inline constexpr int kAtrousChunk = 128;  // pixels whose factors stay in the first-level cache

// Features of one frame at the pixels of a chunk.
struct AtrousFeatures {
  AtrousFeatures(const GBuffer& g, int x0, int y, int n, const AtrousParams& params)
      : z(g.z.row(y) + x0), nx(g.nx.row(y) + x0), ny(g.ny.row(y) + x0), nz(g.nz.row(y) + x0) {
    const float* dz = g.dz.row(y) + x0;
    for (int x = 0; x < n; ++x) r_z[x] = depthFactor(params.sigma_z, z[x], dz[x], params.least_slope);
  }
  const float *z, *nx, *ny, *nz;
  alignas(64) float r_z[kAtrousChunk];
};

// One signal at the pixels of a chunk, and what the filter makes of it.
struct AtrousChannel {
  // With `repeat_edge` the variance repeats its edge outside the picture [ours].
  AtrousChannel(const ImageF& signal, const ImageF& variance, int x0, int y, int n, float sigma_l,
                bool repeat_edge);

  void store(int n, float* c_out, float* v_out) const {
    std::copy_n(filtered, n, c_out);
    std::copy_n(filtered_v, n, v_out);
  }

  const float *c, *v;
  alignas(64) float r_l[kAtrousChunk], filtered[kAtrousChunk], filtered_v[kAtrousChunk];
};

enum class AtrousSignal { kPrimal, kDifference, kDifferenceHeedingPrev, kBoth, kBothHeedingPrev };

struct AtrousChunk {
  const AtrousFeatures &cur, &prev;
  int n;                  // pixels
  std::ptrdiff_t stride;  // of all planes
  int step;
  float sigma_n;
  AtrousKernel kernel;
  AtrousChannel &primal, &difference;
};

// Filter a chunk with lanes of one instruction set.
void filterChunkAvx2(AtrousSignal signal, const AtrousChunk& chunk);
void filterChunkAvx512(AtrousSignal signal, const AtrousChunk& chunk);

}  // namespace saccade
