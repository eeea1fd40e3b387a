#include "eval/tasks/nelder_mead.h"

#include <gtest/gtest.h>

#include <cmath>

namespace saccade::eval {
namespace {

// Rosenbrock's valley, whose minimum is at (1, 1).
TEST(NelderMead, FindsTheEndOfAValley) {
  const auto valley = [](const Variables& v) {
    return 100 * std::pow(v[1] - v[0] * v[0], 2) + std::pow(1 - v[0], 2);
  };
  const Variables best = minimise(valley, {-1.2, 1}, 0.5, 1e-6);
  EXPECT_NEAR(best[0], 1, 1e-4);
  EXPECT_NEAR(best[1], 1, 1e-4);
}

TEST(NelderMead, StopsAfterItsCalls) {
  int calls = 0;
  minimise(
      [&](const Variables& v) {
        ++calls;
        return -v[0] - v[1];  // no minimum
      },
      {0, 0}, 1, 1e-6, 50);
  EXPECT_GE(calls, 50);
  EXPECT_LE(calls, 55);
}

}  // namespace
}  // namespace saccade::eval
