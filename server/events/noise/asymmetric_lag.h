// The lag of a photoreceptor whose rises and falls differ.
#pragma once

#include <algorithm>
#include <cmath>

namespace saccade {

// The node of the photodiode is charged by the photocurrent I, and discharged by the current exp(y) that its
// output y drives. In log units of I, with the lag e = L - y and the rate a of small changes,
//
//   dy/dt = a (1 - exp(-s e)) / s.    [the large signal of Graca and Delbruck, arXiv 2505.07386; s ours]
//
// s is the asymmetry: 1 in the circuit, and 0 in the limit of a linear pole, dy/dt = a e. A large rise is
// slower than that, for the current is no larger than I, and a large fall faster. While L changes by dL in a
// straight line, w = exp(s e) - 1 obeys a linear equation. With a and dL over the piece [ours]
//
//   w' = w exp(-b) + s dL (1 - exp(-b)) / b,    b = a - s dL,    e' = log(1 + w') / s.
//
// `s` in (0, 1], `a` >= 0.
inline double asymmetricLag(double s, double a, double dL, double e) {
  const double b = a - s * dL;
  const double phi = std::abs(b) < 1e-9 ? 1 - b / 2 : -std::expm1(-b) / b;
  const double w = std::expm1(s * e) * std::exp(-b) + s * dL * phi;
  return std::log1p(std::max(w, -1 + 1e-30)) / s;
}

}  // namespace saccade
