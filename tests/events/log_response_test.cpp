#include "events/log_response.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace saccade {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

float response(float I_prev, float dI, float bias) {
  IntensityChange change(1, 1);
  change.I_prev.at(0, 0) = I_prev;
  change.dI.at(0, 0) = dI;
  ImageF dL(1, 1);
  logResponse(change, bias, dL);
  return dL.at(0, 0);
}

TEST(LogResponse, EqualsTheClosedForm) {
  for (const float bias : {1e-8f, 1e-3f, 1.f, 100.f}) {
    for (const float prev : {0.f, 1e-6f, 0.01f, 0.5f, 3.f, 1e6f}) {
      for (const float relative :
           {1e-7f, 1e-3f, 0.2f, 0.41f, 0.42f, 1.f, 7.f, 1e4f, -1e-7f, -1e-3f, -0.29f, -0.3f, -0.9f}) {
        const float dI = relative * prev;
        const double exact = std::log1p(static_cast<double>(dI) / (static_cast<double>(bias) + prev));
        EXPECT_NEAR(response(prev, dI, bias), exact, 1e-6 * std::abs(exact))
            << prev << " " << dI << " " << bias;
      }
    }
  }
}

TEST(LogResponse, NoChangeGivesExactlyZero) {
  for (float prev = 1e-9f; prev < 1e9f; prev *= 1.37f) {
    EXPECT_EQ(response(prev, 0, 1e-3f), 0) << prev;
    EXPECT_EQ(response(prev, -0.f, 1e-8f), 0) << prev;
  }
}

TEST(LogResponse, ClampsAtDarkness) {
  const double exact = std::log(1e-8 / (1e-8 + 1e6));
  EXPECT_NEAR(response(1e6f, -1e6f, 1e-8f), exact, 1e-5);
  EXPECT_NEAR(response(1e6f, -3e6f, 1e-8f), exact, 1e-5);
  EXPECT_NEAR(response(0, 1e6f, 1e-8f), -exact, 1e-5);
  EXPECT_EQ(response(0, -1, 1e-8f), 0);
}

TEST(LogResponse, GivesFiniteNumbersForAnyInput) {
  for (const float prev : {0.f, 1.f, 3e38f, -1.f, -3e38f, 1e-42f, kInf, -kInf, kNan}) {
    for (const float dI : {0.f, 1.f, -1.f, 3e38f, -3e38f, 1e-42f, kInf, -kInf, kNan}) {
      for (const float bias : {1e-12f, 1e6f}) {
        const float dL = response(prev, dI, bias);
        EXPECT_TRUE(std::isfinite(dL)) << prev << " " << dI << " " << bias;
        if (!std::isfinite(prev) || !std::isfinite(dI)) {
          EXPECT_EQ(dL, 0);
        }
      }
    }
  }
}

}  // namespace
}  // namespace saccade
