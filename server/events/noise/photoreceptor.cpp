#include "events/noise/photoreceptor.h"

#include <cmath>
#include <numbers>

#include "base/log_ratio.h"
#include "base/units.h"
#include "events/noise/asymmetric_lag.h"
#include "events/noise/decay.h"

namespace saccade {
namespace {

constexpr float kDark =
    0.1f;  // of the reference luminance: a pixel in the dark has this much of the bandwidth
constexpr float kAtRest = 1e-7f;

float settle(float lag) {
  return std::abs(lag) < kAtRest ? 0 : lag;
}

float rateOf(const auto& poles, float share, float I) {
  const float luminance = I - I == 0 ? clampTo(I + poles.dark, 0, poles.white) : 0;
  return poles.per_luminance * (luminance + kDark * poles.white) * share;
}

// The change of the output of one pixel over `share` of the interval.
template <bool kFollower>
float respond(const auto& poles, float share, float I, float dL, float& lag, float* follower) {
  const float a1 = rateOf(poles, share, I);
  const float before = lag, after = settle(decay(a1) * before + decayBetween(0, a1) * dL);
  lag = after;
  float out = dL + (before - after);
  if constexpr (kFollower) {
    const float g = *follower, a2 = poles.a2 * share;
    const float g_after =
        settle(decay(a2) * g + decayBetween(0, a2) * dL + decayBetween(a1, a2) * (a1 * before - dL));
    *follower = g_after;
    out += g - g_after;
  }
  return out;
}

// The response of poles with an asymmetry. The follower sees a straight line from one end of the piece to the
// other.
float respondAsymmetrically(const auto& poles, float share, float I, float dL, float& lag, float* follower) {
  const float before = lag;
  lag = settle(static_cast<float>(asymmetricLag(poles.asymmetry, rateOf(poles, share, I), dL, before)));
  float out = dL + (before - lag);
  if (follower) {
    const float g = *follower, a2 = poles.a2 * share;
    *follower = settle(decay(a2) * g + decayBetween(0, a2) * out);
    out += g - *follower;
  }
  return out;
}

void filterRowAsymmetrically(const auto& poles, const auto& shareOf, const float* I, int width, float* lag,
                             float* follower, float* dL) {
  for (int x = 0; x < width; ++x)
    dL[x] = respondAsymmetrically(poles, shareOf(x), I[x], dL[x], lag[x], follower ? follower + x : nullptr);
}

template <bool kFollower>
void filterRow(const auto& poles, const auto& shareOf, const float* I, int width, float* __restrict lag,
               float* __restrict follower, float* __restrict dL) {
  for (int x = 0; x < width; ++x)
    dL[x] = respond<kFollower>(poles, shareOf(x), I[x], dL[x], lag[x], follower + (kFollower ? x : 0));
}

// The bandwidth of a pole that has one, else one that leaves no lag.
double bandwidth(double hz, double dt) {
  constexpr double kAtOnce = 1e6;  // 2 pi f dt
  return hz > 0 ? hz : kAtOnce / dt;
}

}  // namespace

// Of an interval: the reference luminance, the dark luminance, a1 over the luminance, a2.
struct Photoreceptor::Poles {
  float white, dark, per_luminance, a2;
  double asymmetry;
};

Photoreceptor::Photoreceptor(const NoiseConfig& noise, int width, int height)
    : noise_(noise), lag_(width, height) {
  change(noise);
}

void Photoreceptor::change(const NoiseConfig& noise) {
  noise_ = noise;
  if (noise.follower_hz > 0 && !follower_lag_)
    follower_lag_ = std::make_unique<ImageF>(lag_.width(), lag_.height());
}

Photoreceptor::Poles Photoreceptor::polesOf(const IntensityChange& change) const {
  const double dt = 2 * std::numbers::pi * seconds(change.t1 - change.t0);
  const double R = noise_.reference_luminance;
  return {static_cast<float>(R), static_cast<float>(noise_.dark_luminance),
          static_cast<float>(bandwidth(noise_.photoreceptor_hz, dt) * dt / (R * (1 + kDark))),
          static_cast<float>(bandwidth(noise_.follower_hz, dt) * dt), noise_.asymmetry};
}

void Photoreceptor::filter(const IntensityChange& change, ImageF& dL, const ImageF* from) {
  const Poles poles = polesOf(change);
  for (int y = 0; y < dL.height(); ++y) {
    const float *I = change.I_now.row(y), *begin = from ? from->row(y) : nullptr;
    float* follower = follower_lag_ ? follower_lag_->row(y) : nullptr;
    const auto filter = [&](const auto& shareOf) {
      if (noise_.asymmetry > 0) {
        filterRowAsymmetrically(poles, shareOf, I, dL.width(), lag_.row(y), follower, dL.row(y));
      } else if (follower) {
        filterRow<true>(poles, shareOf, I, dL.width(), lag_.row(y), follower, dL.row(y));
      } else {
        filterRow<false>(poles, shareOf, I, dL.width(), lag_.row(y), follower, dL.row(y));
      }
    };
    if (begin) {
      filter([&](int x) { return 1 - begin[x]; });
    } else {
      filter([](int) { return 1.f; });
    }
  }
  if (noise_.follower_hz == 0) follower_lag_.reset();
}

void Photoreceptor::filter(const IntensityChange& change, Pieces& pieces) {
  const Poles poles = polesOf(change);
  for (int i = 0; i < pieces.count; ++i) {
    const float share = pieces.to[i] - pieces.from[i], I = pieces.I[i];
    float &lag = lag_.at(pieces.x[i], pieces.y[i]), &dL = pieces.dL[i];
    float* follower = follower_lag_ ? &follower_lag_->at(pieces.x[i], pieces.y[i]) : nullptr;
    if (noise_.asymmetry > 0) {
      dL = respondAsymmetrically(poles, share, I, dL, lag, follower);
    } else {
      dL = follower ? respond<true>(poles, share, I, dL, lag, follower)
                    : respond<false>(poles, share, I, dL, lag, nullptr);
    }
  }
}

std::optional<Photoreceptor> makePhotoreceptor(const NoiseConfig& noise, int width, int height) {
  if (noise.photoreceptor_hz == 0) return std::nullopt;
  return Photoreceptor(noise, width, height);
}

}  // namespace saccade
