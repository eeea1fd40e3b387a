// Splits an error into bias and noise, both free of the noise of the reference. The reference comes in two
// independent halves a and b. The mean of (x - a)(x - b) over their noise is (x - truth)^2, while (x - ref)^2
// is too large.
#pragma once

#include "eval/metrics/regions.h"
#include "eval/metrics/repeats.h"

namespace saccade::eval {

// Root mean squares over pixels, in the unit of the plane. A mean square may come out below zero where the
// error is lost in the noise; its root is then given as negative. NaN if no pixel is in the regions.
struct ErrorParts {
  double rms;     // of one repeat; rms^2 = bias^2 + noise^2
  double bias;    // of the mean over all seeds: more samples do not reduce it
  double noise;   // of one repeat about that mean
  double offset;  // signed mean of the bias: too bright, or too dark
};

// Over the pixels in any of the regions `which`. Needs two repeats or more.
ErrorParts errorParts(const Repeats& x, const ImageF& a, const ImageF& b, const RegionMap& regions,
                      std::uint32_t which);

// The rms of a single estimate x.
double rmsError(const ImageF& x, const ImageF& a, const ImageF& b, const RegionMap& regions,
                std::uint32_t which);

}  // namespace saccade::eval
