#include "methods/learned_denoiser.h"

#include <utility>

namespace saccade {
namespace {

constexpr float kMostLight = 1e18f;  // as in demodulate(): squares of it are finite

}  // namespace

LearnedDenoiser::LearnedDenoiser(std::unique_ptr<PictureDenoiser> denoiser, int w, int h)
    : denoiser_(std::move(denoiser)), I_prev_(w, h) {}

std::chrono::nanoseconds LearnedDenoiser::denoise(const Frame& frame, const PoolHandle& pool, ImageF& I) {
  return pool.run(1, [&](int) {
    denoiser_->denoise(frame, I);
    for (int y = 0; y < I.height(); ++y) {
      float* row = I.row(y);
      for (int x = 0; x < I.width(); ++x) row[x] = row[x] > 0 && row[x] <= kMostLight ? row[x] : 0.f;
    }
  });
}

void LearnedDenoiser::start(const Frame& first, const PoolHandle& pool) {
  denoise(first, pool, I_prev_);
}

void LearnedDenoiser::estimate(const FramePair& frames, const PoolHandle& pool, IntensityChange& out,
                               StageTimes& times) {
  times[Stage::kAtrous] += denoise(frames.cur, pool, out.I_now);
  times[Stage::kModulate] += pool.forEachRow(out.dI.height(), [&](int y) {
    const float* now = out.I_now.row(y);
    float *kept = I_prev_.row(y), *before = out.I_prev.row(y), *dI = out.dI.row(y);
    for (int x = 0; x < out.dI.width(); ++x) {
      before[x] = kept[x], dI[x] = now[x] - kept[x];
      kept[x] = now[x];
    }
  });
}

}  // namespace saccade
