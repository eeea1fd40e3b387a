#include "eval/figures/spectrum.h"

#include <complex>
#include <numbers>
#include <numeric>

#include "base/check.h"

namespace saccade::eval {
namespace {

// exp(-2 pi i n / N), n = 0 to N - 1.
std::vector<std::complex<double>> rootsOfOne(std::size_t N) {
  std::vector<std::complex<double>> roots(N);
  for (std::size_t n = 0; n < N; ++n)
    roots[n] = std::polar(1.0, -2 * std::numbers::pi * static_cast<double>(n) / static_cast<double>(N));
  return roots;
}

}  // namespace

double Spectrum::powerAbove(double from_hz) const {
  double sum = 0;
  for (std::size_t k = 0; k < density.size(); ++k) sum += hz(k) > from_hz ? density[k] * step_hz : 0;
  return sum;
}

Spectrum powerSpectrum(const std::vector<double>& x, double rate_hz) {
  const std::size_t N = x.size();
  SACCADE_CHECK(N >= 2);
  const auto roots = rootsOfOne(N);
  const double mean = std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(N);
  std::vector<double> windowed(N);
  double window_power = 0;
  for (std::size_t n = 0; n < N; ++n) {
    const double window = (1 - roots[n].real()) / 2;
    windowed[n] = window * (x[n] - mean);
    window_power += window * window;
  }
  Spectrum spectrum{rate_hz / static_cast<double>(N), {}};
  for (std::size_t k = 1; k <= N / 2; ++k) {
    std::complex<double> sum = 0;
    for (std::size_t n = 0, turn = 0; n < N; ++n) {
      sum += windowed[n] * roots[turn];
      turn += turn + k < N ? k : k - N;  // k n modulo N
    }
    const double sides = 2 * k == N ? 1 : 2;  // but for half the rate, its mirror image has as much
    spectrum.density.push_back(sides * std::norm(sum) / (window_power * rate_hz));
  }
  return spectrum;
}

void operator+=(Spectrum& sum, const Spectrum& x) {
  if (sum.density.empty()) {
    sum = x;
    return;
  }
  SACCADE_CHECK(sum.density.size() == x.density.size());
  for (std::size_t k = 0; k < x.density.size(); ++k) sum.density[k] += x.density[k];
}

}  // namespace saccade::eval
