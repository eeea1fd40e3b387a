#include "events/noise/photoreceptor.h"

#include <cmath>
#include <numbers>

#include "base/units.h"
#include "events/log_ratio.h"
#include "events/noise/decay.h"

namespace saccade {
namespace {

constexpr float kDark =
    0.1f;  // of the reference luminance: a pixel in the dark has this much of the bandwidth
constexpr float kAtRest = 1e-7f;

float settle(float lag) {
  return std::abs(lag) < kAtRest ? 0 : lag;
}

template <bool kFollower>
class Poles final : public Photoreceptor {
 public:
  Poles(const NoiseConfig& noise, int width, int height)
      : noise_(noise), lag_(width, height), follower_lag_(kFollower ? width : 1, kFollower ? height : 1) {}

  void filter(const IntensityChange& change, ImageF& dL) override {
    const double dt = 2 * std::numbers::pi * seconds(change.t1 - change.t0);
    const double R = noise_.reference_luminance;
    const Row row{.white = static_cast<float>(R),
                  .per_luminance = static_cast<float>(noise_.photoreceptor_hz * dt / (R * (1 + kDark))),
                  .a2 = static_cast<float>(noise_.follower_hz * dt)};
    for (int y = 0; y < dL.height(); ++y) {
      float* follower = kFollower ? follower_lag_.row(y) : nullptr;
      filterRow(row, change.I_now.row(y), dL.width(), lag_.row(y), follower, dL.row(y));
    }
  }

 private:
  struct Row {
    float white, per_luminance, a2;
  };

  static void filterRow(const Row& row, const float* I, int width, float* __restrict lag,
                        float* __restrict follower, float* __restrict dL) {
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

  NoiseConfig noise_;
  ImageF lag_, follower_lag_;
};

}  // namespace

std::unique_ptr<Photoreceptor> makePhotoreceptor(const NoiseConfig& noise, int width, int height) {
  if (noise.photoreceptor_hz == 0) return nullptr;
  if (noise.follower_hz > 0) return std::make_unique<Poles<true>>(noise, width, height);
  return std::make_unique<Poles<false>>(noise, width, height);
}

}  // namespace saccade
