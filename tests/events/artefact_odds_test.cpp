#include "events/artefact_odds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <random>

#include "events/sensor.h"

namespace saccade {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(ArtefactOdds, HaveTheirLimits) {
  EXPECT_EQ(artefactOdds(1, 0, 1), 0);
  EXPECT_EQ(artefactOdds(1, std::nan(""), 1), 0);
  EXPECT_NEAR(artefactOdds(1e-9, 1, kInfinity), 0.5, 1e-6);
  EXPECT_NEAR(artefactOdds(100, 1, kInfinity), 1 / std::sqrt(2 * std::numbers::pi) / 100, 1e-9);
  EXPECT_NEAR(artefactOdds(1, 1e6, 1e-6), 1, 1e-5);
  EXPECT_EQ(artefactOdds(0, 1, 0), 0.5);
  EXPECT_EQ(artefactOdds(1, kInfinity, 1), 0.5);
  EXPECT_EQ(artefactOdds(-0.3, 0.2, 0.4), artefactOdds(0.3, 0.2, 0.4));
}

// Normal changes, normal errors: in pixels that seem to change by about dL, the events beyond the true change
// are the false ones.
TEST(ArtefactOdds, AreTheShareOfFalseEvents) {
  std::mt19937 random(1);
  for (const double tau : {0.4, 1.0, 20.0}) {
    std::normal_distribution<double> truths(0, tau), errors(0, 1);
    for (const double dL : {0.25, 1.0, 2.5}) {
      double sent = 0, wrong = 0;
      for (int i = 0; i < 2'000'000; ++i) {
        const double truth = truths(random), seen = truth + errors(random);
        if (std::abs(seen - dL) > 0.05) continue;
        sent += seen;
        wrong += std::clamp(seen - truth, 0.0, seen);
      }
      EXPECT_NEAR(wrong / sent, artefactOdds(dL, 1, tau), 0.02) << dL << " " << tau;
    }
  }
}

// Pixels that brighten by 0.5, in four strips with errors of 0, 0.05, 0.5 and 5.
class JudgedSensor : public testing::Test {
 protected:
  JudgedSensor() {
    change_.frame = 1;
    change_.t1 = TimeNs(2'000'000);
    change_.I_prev.fill(2);
    change_.dI.fill(kNow - 2);
    change_.I_now.fill(kNow);
    for (int x = 0; x < kWidth; ++x)
      for (int y = 0; y < 3; ++y) change_.var_dI.at(x, y) = kSigma[x / 3] * kSigma[x / 3] * kNow * kNow;
  }
  SensorOutput run(const SensorConfig& config) {
    SensorOutput out;
    Sensor(config, kWidth, 3).generate(change_, out);
    return out;
  }
  // Of the events in the middle of strip `i`, in unit 1; fails unless they are equal.
  double oddsIn(int i) {
    std::optional<std::uint8_t> odds;
    for (const Event& event : run(labelled()).events) {
      if (event.x != 3 * i + 1) continue;
      EXPECT_EQ(odds.value_or(event.artefact), event.artefact);
      odds = event.artefact;
    }
    return odds.value() / 255.0;
  }
  SensorConfig labelled() const {
    SensorConfig config = plain_;
    config.labels = true;
    return config;
  }
  static constexpr int kWidth = 12;
  static constexpr float kSigma[] = {0, 0.05f, 0.5f, 5}, kNow = 3.2974425f;  // 2 e^0.5
  const SensorConfig plain_{
      .threshold = 0.1, .threshold_off = 0.1, .bias = 1e-12, .reconstruction = "direct"};
  IntensityChange change_{kWidth, 3};
};

TEST_F(JudgedSensor, LabelsEachEvent) {
  const SensorOutput out = run(labelled());
  EXPECT_EQ(out.suppressed, 0u);
  EXPECT_GE(out.events.size(), 16u);
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(oddsIn(i), artefactOdds(0.5, kSigma[i], 0.5), 0.003) << i;
}

// The change and the pictures differ by 0.5 of the brightness.
TEST_F(JudgedSensor, CountsDisagreementAsError) {
  change_.I_now.fill(1.5f * kNow);
  EXPECT_NEAR(oddsIn(0), artefactOdds(0.5, 0.5, 0.5), 0.003);
}

// Errors of the change count at the brightness it ends at: here a tenth of what was.
TEST_F(JudgedSensor, CountsErrorsAtTheNewBrightness) {
  change_.I_prev.fill(10 * kNow);
  change_.dI.fill(-9 * kNow);
  EXPECT_NEAR(oddsIn(2), artefactOdds(-std::log(10), 0.5, std::log(10)), 0.003);
}

TEST_F(JudgedSensor, HasNoOddsWhereNothingIsFinite) {
  change_.I_now.fill(std::nanf(""));
  EXPECT_EQ(oddsIn(2), 0);
}

TEST_F(JudgedSensor, WithholdsAndCountsLikelyArtefacts) {
  SensorConfig config = labelled();
  config.max_artefact_odds = 0.2;
  Events whole = run(labelled()).events;
  const SensorOutput kept = run(config);
  const auto likely = std::erase_if(whole, [](const Event& e) { return e.artefact > 0.2 * 255; });
  EXPECT_GT(likely, 0u);
  EXPECT_EQ(kept.artefacts, likely);
  EXPECT_EQ(kept.suppressed, kept.artefacts);
  EXPECT_EQ(kept.events, whole);
}

}  // namespace
}  // namespace saccade
