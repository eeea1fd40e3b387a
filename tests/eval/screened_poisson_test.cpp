#include "eval/figures/screened_poisson.h"

#include <gtest/gtest.h>

#include <cmath>

namespace saccade::eval {
namespace {

TEST(ScreenedPoisson, KeepsWhatAgrees) {
  const std::vector<double> L{0.3, -1, 2, 2.5, 0};
  std::vector<double> dL;
  for (std::size_t t = 1; t < L.size(); ++t) dL.push_back(L[t] - L[t - 1]);
  const std::vector<double> solved = screenedPoisson(L, dL, 0.2);
  for (std::size_t t = 0; t < L.size(); ++t) EXPECT_NEAR(solved[t], L[t], 1e-12);
}

// The Green's function of the equations, far from both ends.
TEST(ScreenedPoisson, SpreadsNoiseOfThePrimal) {
  constexpr std::size_t kFrames = 201, kAt = 100;
  const double lambda = 0.04, rho = 1 + lambda / 2 - std::sqrt(lambda + lambda * lambda / 4);
  std::vector<double> prim(kFrames);
  prim[kAt] = 1;
  const std::vector<double> solved = screenedPoisson(prim, std::vector<double>(kFrames - 1), 0.2);
  for (const int k : {0, 1, 7, -7})
    EXPECT_NEAR(solved[kAt + static_cast<std::size_t>(k)],
                lambda / std::sqrt(lambda * (lambda + 4)) * std::pow(rho, std::abs(k)), 1e-9);
}

// An error of every change adds up to no drift.
TEST(ScreenedPoisson, StopsADrift) {
  const std::vector<double> solved =
      screenedPoisson(std::vector<double>(301), std::vector<double>(300, 0.01), 0.2);
  EXPECT_NEAR(solved[150], 0, 1e-9);
  EXPECT_LT(std::abs(solved[300]), 0.01 / 0.2 * 1.1);
}

}  // namespace
}  // namespace saccade::eval
