// The low pass of the photoreceptor against the responses of one and two poles.
#include "events/noise/photoreceptor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "events/noise/decay.h"

namespace saccade {
namespace {

constexpr double kPi = std::numbers::pi;

// One pixel of intensity I, driven by log brightness at the ends of intervals.
struct Pixel {
  Pixel(const NoiseConfig& noise, float I) : filter(makePhotoreceptor(noise, 1, 1)), change(1, 1), dL(1, 1) {
    change.I_now.at(0, 0) = I;
  }

  // Moves log brightness by `step` within `length`; returns the output.
  double move(double step, TimeNs length) {
    change.t1 = change.t0 + length;
    dL.at(0, 0) = static_cast<float>(step);
    filter->filter(change, dL);
    return output += dL.at(0, 0);
  }

  std::optional<Photoreceptor> filter;
  IntensityChange change;
  ImageF dL;
  double output = 0;
};

TEST(Decay, IsTheExponentialAndItsDividedDifference) {
  for (double a = 0; a < 80; a += 0.013) {
    EXPECT_NEAR(decay(static_cast<float>(a)) / std::exp(-a), 1, 1e-5 + 1e-6 * a) << a;
  }
  for (const double a : {0.0, 1e-6, 0.3, 2.0, 9.0}) {
    for (const double b : {0.0, 2e-6, 0.301, 0.7, 2.9, 30.0}) {
      const double expected = a == b ? std::exp(-a) : -std::exp(-a) * std::expm1(a - b) / (b - a);
      EXPECT_NEAR(decayBetween(static_cast<float>(a), static_cast<float>(b)) / expected, 1, 1e-5)
          << a << " " << b;
    }
  }
}

TEST(Photoreceptor, AStepOfOnePoleDecaysExponentially) {
  constexpr double kHz = 30;
  for (const TimeNs length : {TimeNs(100'000), TimeNs(2'000'000), TimeNs(50'000'000)}) {
    Pixel pixel({.photoreceptor_hz = kHz}, 1);
    pixel.move(1, TimeNs(1'000));  // a step
    double t = 0;
    for (int i = 0; i < 20; ++i) {
      t += seconds(length);
      EXPECT_NEAR(pixel.move(0, length), 1 - std::exp(-2 * kPi * kHz * t), 2e-4) << t;
    }
  }
}

TEST(Photoreceptor, AStepOfTwoPolesFollowsTheirFormula) {
  constexpr double f1 = 30, f2 = 200, w1 = 2 * kPi * f1, w2 = 2 * kPi * f2;
  Pixel pixel({.photoreceptor_hz = f1, .follower_hz = f2}, 1),
      equal({.photoreceptor_hz = f1, .follower_hz = f1}, 1);
  pixel.move(1, TimeNs(1'000)), equal.move(1, TimeNs(1'000));
  for (double t = 1e-3; t < 0.03; t += 1e-3) {
    const double expected = 1 - (w2 * std::exp(-w1 * t) - w1 * std::exp(-w2 * t)) / (w2 - w1);
    EXPECT_NEAR(pixel.move(0, TimeNs(1'000'000)), expected, 2e-4) << t;
    EXPECT_NEAR(equal.move(0, TimeNs(1'000'000)), 1 - (1 + w1 * t) * std::exp(-w1 * t), 2e-4) << t;
  }
}

// In the steady state a sine of frequency f has the gain 1 / ((1 + j f / f1) (1 + j f / f2)).
TEST(Photoreceptor, ASineHasTheGainAndPhaseOfThePoles) {
  constexpr double kHz = 50;
  for (const double follower : {0.0, 120.0}) {
    for (const double f : {5.0, 50.0, 200.0}) {
      Pixel pixel({.photoreceptor_hz = kHz, .follower_hz = follower}, 1);
      constexpr int kSteps = 1000;  // of a period
      const TimeNs length(std::llround(1e9 / f / kSteps));
      std::complex<double> response = 0;
      for (int i = 0; i < 40 * kSteps; ++i) {
        const double phase = 2 * kPi * i / kSteps, next = 2 * kPi * (i + 1) / kSteps;
        const double output = pixel.move(std::sin(next) - std::sin(phase), length);
        const int from = 39 * kSteps;  // the last period
        if (i >= from) response += output * std::polar(2.0 / kSteps, -(next - kPi / 2));
      }
      const std::complex<double> j(0, 1);
      const auto expected = 1.0 / ((1.0 + j * f / kHz) * (follower > 0 ? 1.0 + j * f / follower : 1.0));
      EXPECT_NEAR(std::abs(response - expected), 0, 3e-3) << f << " " << follower;
    }
  }
}

// f(I) = photoreceptor_hz (min(I, R) + R / 10) / (1.1 R)
TEST(Photoreceptor, TheBandwidthFollowsIntensityUpToTheReference) {
  for (const auto& [I, share] :
       {std::pair(0.f, 1 / 11.0), {1.f, 6 / 11.0}, {2.f, 1.0}, {9.f, 1.0}, {NAN, 1 / 11.0}}) {
    Pixel pixel({.photoreceptor_hz = 20, .reference_luminance = 2}, I);
    pixel.move(1, TimeNs(1'000));
    EXPECT_NEAR(pixel.move(0, TimeNs(5'000'000)), 1 - std::exp(-2 * kPi * 20 * share * 5e-3), 2e-4) << I;
  }
}

TEST(Photoreceptor, ComesToRest) {
  Pixel pixel({.photoreceptor_hz = 30, .follower_hz = 90}, 1);
  pixel.move(1, TimeNs(1'000'000));
  for (int i = 0; i < 200; ++i) pixel.move(0, TimeNs(1'000'000));
  EXPECT_EQ(pixel.move(0, TimeNs(1'000'000)), pixel.output);
  EXPECT_EQ(pixel.dL.at(0, 0), 0);
  EXPECT_NEAR(pixel.output, 1, 1e-5);
}

// After a step S the lag is log(1 + (exp(s S) - 1) exp(-a t)) / s. So a rise is slower than that of a linear
// pole, and a fall faster.
TEST(Photoreceptor, AnAsymmetricStepHasTheLargeSignalOfTheCircuit) {
  constexpr double kHz = 30;
  for (const double s : {1.0, 0.5})
    for (const double step : {2.0, -2.0, 0.01})
      for (const TimeNs length : {TimeNs(500'000), TimeNs(8'000'000)}) {
        Pixel pixel({.photoreceptor_hz = kHz, .asymmetry = s}, 1);
        pixel.move(step, TimeNs(1'000));
        double t = 0;
        for (int i = 0; i < 20; ++i) {
          t += seconds(length);
          const double lag = std::log1p(std::expm1(s * step) * std::exp(-2 * kPi * kHz * t)) / s;
          EXPECT_NEAR(pixel.move(0, length), step - lag, 1e-3) << s << ' ' << step << ' ' << t;
          EXPECT_TRUE(std::abs(step) < 1 ||
                      (std::abs(lag) > 2 * std::exp(-2 * kPi * kHz * t)) == (step > 0) ||
                      std::abs(lag) < 1e-6);
        }
      }
}

// Half of a rise S has passed after ln(exp(S / 2) + 1) / a. For a fall it is ln(1 + exp(-S / 2)) / a.
TEST(Photoreceptor, ALargeFallPassesSoonerThanARise) {
  constexpr double kHz = 10, kStep = 3;
  for (const double sign : {1.0, -1.0}) {
    Pixel pixel({.photoreceptor_hz = kHz, .asymmetry = 1}, 1);
    pixel.move(sign * kStep, TimeNs(1'000));
    double t = 0;
    while (std::abs(pixel.output) < kStep / 2) pixel.move(0, TimeNs(10'000)), t += 1e-5;
    EXPECT_NEAR(t, std::log(1 + std::exp(sign * kStep / 2)) / (2 * kPi * kHz), 2e-5) << sign;
  }
}

TEST(Photoreceptor, OneRampOrManyPiecesOfItAreTheSame) {
  for (const double slope : {40.0, -40.0}) {
    Pixel whole({.photoreceptor_hz = 30, .asymmetry = 1}, 1),
        fine({.photoreceptor_hz = 30, .asymmetry = 1}, 1);
    const double coarse = whole.move(slope * 0.016, TimeNs(16'000'000));
    for (int i = 0; i < 16; ++i) fine.move(slope * 0.001, TimeNs(1'000'000));
    EXPECT_NEAR(coarse, fine.output, 1e-5);
  }
}

TEST(Photoreceptor, ASmallAsymmetryIsALinearPole) {
  Pixel linear({.photoreceptor_hz = 30}, 1), nearly({.photoreceptor_hz = 30, .asymmetry = 1e-6}, 1);
  for (int i = 0; i < 50; ++i) {
    const double step = std::sin(0.3 * i);
    EXPECT_NEAR(linear.move(step, TimeNs(2'000'000)), nearly.move(step, TimeNs(2'000'000)), 1e-4);
  }
}

// Against dy/dt = a1 (1 - exp(y - L)), dz/dt = a2 (y - z) in steps of 0.5 us.
TEST(Photoreceptor, AFollowerBehindAnAsymmetryFollows) {
  constexpr double kHz = 30, kFollower = 80, dt = 5e-7;
  Pixel pixel({.photoreceptor_hz = kHz, .follower_hz = kFollower, .asymmetry = 1}, 1);
  double L = 0, y = 0, z = 0;
  for (int i = 0; i < 60; ++i) {
    const double step = i < 10 ? 0.2 : i < 30 ? -0.1 : 0;
    for (int k = 0; k < 2000; ++k) {
      z += dt * 2 * kPi * kFollower * (y - z);
      y += dt * 2 * kPi * kHz * (1 - std::exp(y - L));
      L += step / 2000;
    }
    EXPECT_NEAR(pixel.move(step, TimeNs(1'000'000)), z, 3e-3) << i;
  }
}

TEST(Photoreceptor, DarkCurrentIsLight) {
  Pixel dark({.photoreceptor_hz = 30, .dark_luminance = 0.7}, 0.3f), bright({.photoreceptor_hz = 30}, 1);
  for (int i = 0; i < 20; ++i)
    EXPECT_FLOAT_EQ(static_cast<float>(dark.move(0.1, TimeNs(2'000'000))),
                    static_cast<float>(bright.move(0.1, TimeNs(2'000'000))));
}

}  // namespace
}  // namespace saccade
