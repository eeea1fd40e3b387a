// The power spectrum of a series of frames.
#pragma once

#include <vector>

namespace saccade::eval {

// One-sided density: the power between two frequencies is the sum of density * step_hz.
struct Spectrum {
  double step_hz = 0;
  std::vector<double> density;  // at (k + 1) * step_hz, up to half the frame rate; unit of the series^2 / Hz

  double hz(std::size_t k) const { return static_cast<double>(k + 1) * step_hz; }
  double powerAbove(double hz) const;  // of frequencies > hz, unit of the series^2
};

// The discrete Fourier transform of the deviation from the mean, under a Hann window whose power is divided
// out. The first step also holds the mean and slower changes, as far as they leak through the window. `x`:
// two values or more.
Spectrum powerSpectrum(const std::vector<double>& x, double rate_hz);

// Adds the spectrum of a series of the same length and rate. An empty spectrum becomes `x`.
void operator+=(Spectrum& sum, const Spectrum& x);

}  // namespace saccade::eval
