// Screened Poisson reconstruction of brightness over time (paper, Fig. 7; Kettunen et al. 2015 over space): a
// global solution, which needs all frames at once.
//
//   min over L of   alpha^2 sum_t (L_t - L^prim_t)^2 + sum_t (L_t - L_{t-1} - dL_t)^2
//
// With lambda = alpha^2 its normal equations are
// (lambda + 2) L_t - L_{t-1} - L_{t+1} = lambda L^prim_t + dL_t - dL_{t+1}. An impulse in L^prim shows as
// rho^|k| k frames away, rho = 1 + lambda / 2 - sqrt(lambda + lambda^2 / 4).
#pragma once

#include "eval/bench/sequence.h"

namespace saccade::eval {

inline constexpr double kPoissonAlpha = 0.2;  // of gradient-domain path tracing

// Of one pixel. `prim` has one value more than `dL`.
std::vector<double> screenedPoisson(const std::vector<double>& prim, const std::vector<double>& dL,
                                    double alpha);

// Of every pixel of a run. L^prim is log(I_eps + D[I]).
BrightnessSequence screenedPoisson(const ChangeSequence& run, double bias, double alpha = kPoissonAlpha);

}  // namespace saccade::eval
