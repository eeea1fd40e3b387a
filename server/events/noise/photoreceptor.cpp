#include "events/noise/photoreceptor.h"

#include <cmath>
#include <numbers>

#include "base/log_ratio.h"
#include "base/units.h"
#include "events/noise/decay.h"

namespace saccade {
namespace {

constexpr float kDark =
    0.1f;  // of the reference luminance: a pixel in the dark has this much of the bandwidth
constexpr float kAtRest = 1e-7f;

float settle(float lag) {
  return std::abs(lag) < kAtRest ? 0 : lag;
}

// Of a row of pixels: the reference luminance, a1 over the luminance, a2.
struct Row {
  float white, per_luminance, a2;
};

template <bool kFollower>
void filterRow(const Row& row, const float* I, int width, float* __restrict lag, float* __restrict follower,
               float* __restrict dL) {
  for (int x = 0; x < width; ++x) {
    const float luminance = I[x] - I[x] == 0 ? clampTo(I[x], 0, row.white) : 0;
    const float a1 = row.per_luminance * (luminance + kDark * row.white);
    const float before = lag[x], after = settle(decay(a1) * before + decayBetween(0, a1) * dL[x]);
    lag[x] = after;
    float out = dL[x] + (before - after);
    if constexpr (kFollower) {
      const float g = follower[x];
      const float g_after = settle(decay(row.a2) * g + decayBetween(0, row.a2) * dL[x] +
                                   decayBetween(a1, row.a2) * (a1 * before - dL[x]));
      follower[x] = g_after;
      out += g - g_after;
    }
    dL[x] = out;
  }
}

// The bandwidth of a pole that has one, else one that leaves no lag.
double bandwidth(double hz, double dt) {
  constexpr double kAtOnce = 1e6;  // 2 pi f dt
  return hz > 0 ? hz : kAtOnce / dt;
}

}  // namespace

Photoreceptor::Photoreceptor(const NoiseConfig& noise, int width, int height)
    : noise_(noise), lag_(width, height) {
  change(noise);
}

void Photoreceptor::change(const NoiseConfig& noise) {
  noise_ = noise;
  if (noise.follower_hz > 0 && !follower_lag_)
    follower_lag_ = std::make_unique<ImageF>(lag_.width(), lag_.height());
}

void Photoreceptor::filter(const IntensityChange& change, ImageF& dL) {
  const double dt = 2 * std::numbers::pi * seconds(change.t1 - change.t0);
  const double R = noise_.reference_luminance;
  const Row row{
      .white = static_cast<float>(R),
      .per_luminance = static_cast<float>(bandwidth(noise_.photoreceptor_hz, dt) * dt / (R * (1 + kDark))),
      .a2 = static_cast<float>(bandwidth(noise_.follower_hz, dt) * dt)};
  for (int y = 0; y < dL.height(); ++y) {
    const float* I = change.I_now.row(y);
    if (follower_lag_) {
      filterRow<true>(row, I, dL.width(), lag_.row(y), follower_lag_->row(y), dL.row(y));
    } else {
      filterRow<false>(row, I, dL.width(), lag_.row(y), nullptr, dL.row(y));
    }
  }
  if (noise_.follower_hz == 0) follower_lag_.reset();
}

std::optional<Photoreceptor> makePhotoreceptor(const NoiseConfig& noise, int width, int height) {
  if (noise.photoreceptor_hz == 0) return std::nullopt;
  return Photoreceptor(noise, width, height);
}

}  // namespace saccade
