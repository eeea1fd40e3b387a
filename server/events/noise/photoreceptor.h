// The bandwidth of the photoreceptor: an intensity-dependent low pass of log brightness.
#pragma once

#include <memory>
#include <optional>

#include "events/noise/noise_config.h"
#include "events/pieces.h"
#include "frame/intensity_change.h"

namespace saccade {

// One pole, or two in a row. Log brightness L is linear inside each piece; the poles see exactly that ramp.
//
//   f(I) = photoreceptor_hz (min(I, R) + R / 10) / (R + R / 10)   [v2e: (I + 20) / 275]
//   a = 2 pi f dt,  q = exp(-a),  phi(a, b) = (exp(-a) - exp(-b)) / (b - a)
//   e' = q1 e + phi(0, a1) dL
//   g' = q2 g + phi(0, a2) dL + phi(a1, a2) (a1 e - dL)
//   dL becomes dL - (e' - e) - (g' - g)          [ours: the exact response to a ramp]
//
// R is the reference luminance. The lag of the photoreceptor is e, L minus its output, with a1. The lag of
// the follower is g; its a2 is the same everywhere.
//
// dt is the length of the piece, and I the intensity at its end. Both lags are 0 at first: the pixels have
// seen the first frame for long. Lags below 1e-7 become 0, so that a scene at rest comes to rest.
class Photoreceptor {
 public:
  Photoreceptor(const NoiseConfig& noise, int width, int height);

  // Other bandwidths from the next interval on; the lags stay. A pole without a bandwidth follows at once:
  // its lag comes out in the next interval. A new follower has no lag.
  void change(const NoiseConfig& noise);
  // Replaces `dL` by the change of the output over the interval, or over the last piece of each pixel. That
  // begins at the share `from` of the interval. Does not touch the border, and does not allocate.
  void filter(const IntensityChange& change, ImageF& dL, const ImageF* from = nullptr);
  // Filters pieces of the interval in the same way, before its last ones.
  void filter(const IntensityChange& change, Pieces& pieces);

 private:
  struct Poles;
  Poles polesOf(const IntensityChange& change) const;

  NoiseConfig noise_;
  ImageF lag_;
  std::unique_ptr<ImageF> follower_lag_;  // of two poles
};

// Nothing where photoreceptor_hz is 0.
std::optional<Photoreceptor> makePhotoreceptor(const NoiseConfig& noise, int width, int height);

}  // namespace saccade
