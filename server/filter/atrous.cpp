#include "filter/atrous.h"

#include <algorithm>

#include "base/check.h"
#include "base/instruction_set.h"
#include "filter/atrous_chunk.h"

namespace saccade {
namespace {

constexpr float kGauss[2] = {1.f / 2, 1.f / 4};  // g_3x3, separable, by distance

AtrousSignal signalOf(const AtrousParams& params) {
  if (!params.difference) return AtrousSignal::kPrimal;
  if (!params.primal)
    return params.use_prev ? AtrousSignal::kDifferenceHeedingPrev : AtrousSignal::kDifference;
  return params.use_prev ? AtrousSignal::kBothHeedingPrev : AtrousSignal::kBoth;
}

}  // namespace

AtrousChannel::AtrousChannel(const ImageF& signal, const ImageF& variance, int x0, int y, int n,
                             float sigma_l, bool repeat_edge)
    : c(signal.row(y) + x0), v(variance.row(y) + x0) {
  const std::ptrdiff_t stride = variance.stride();
  const std::ptrdiff_t up = !repeat_edge || y > 0 ? -stride : 0;
  const std::ptrdiff_t down = !repeat_edge || y + 1 < variance.height() ? stride : 0;
  const auto factor = [&](int x, std::ptrdiff_t left, std::ptrdiff_t right) {
    const auto across = [&](const float* p) { return kGauss[0] * p[0] + kGauss[1] * (p[left] + p[right]); };
    const float* p = v + x;
    return luminanceFactor(sigma_l, kGauss[0] * across(p) + kGauss[1] * (across(p + up) + across(p + down)));
  };
  for (int x = 0; x < n; ++x) r_l[x] = factor(x, -1, 1);
  if (!repeat_edge || n == 0) return;
  const bool last = x0 + n == variance.width();
  if (x0 == 0) r_l[0] = factor(0, 0, last && n == 1 ? 0 : 1);
  if (last) r_l[n - 1] = factor(n - 1, x0 + n == 1 ? 0 : -1, 0);
}

std::chrono::nanoseconds atrousIteration(const FramePair& frames, const AtrousParams& params, int step,
                                         const FilterPlanes& in, const PoolHandle& pool, FilterPlanes& out) {
  static_assert(2 * kMaxAtrousStep <= ImageF::kBorder);
  SACCADE_CHECK(step <= kMaxAtrousStep && (params.primal || params.difference));
  const int width = in.i.width();
  const AtrousSignal signal = signalOf(params);
  const auto filter = instructionSet() == InstructionSet::kAvx512 ? filterChunkAvx512 : filterChunkAvx2;
  return pool.forEachRow(in.i.height(), [&](int y) {
    for (int x0 = 0; x0 < width; x0 += kAtrousChunk) {
      const int n = std::min(kAtrousChunk, width - x0);
      // A count of 0 skips the planes that the filter does not read.
      const int n_primal = params.primal ? n : 0;
      const int n_diff = params.difference ? n : 0, n_prev = params.use_prev ? n_diff : 0;
      const AtrousFeatures cur(frames.cur.g, x0, y, n, params), prev(frames.prev.g, x0, y, n_prev, params);
      AtrousChannel primal(in.i, in.var_i, x0, y, n_primal, params.sigma_l, params.repeat_edge_variance);
      AtrousChannel difference(in.d, in.var_d, x0, y, n_diff, params.sigma_l_diff,
                               params.repeat_edge_variance);
      filter(signal, {cur, prev, n, in.i.stride(), step, params.sigma_n, params.kernel, primal, difference});
      primal.store(n_primal, out.i.row(y) + x0, out.var_i.row(y) + x0);
      difference.store(n_diff, out.d.row(y) + x0, out.var_d.row(y) + x0);
    }
  });
}

}  // namespace saccade
