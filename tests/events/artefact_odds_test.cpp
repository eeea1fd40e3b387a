#include "events/artefact_odds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "events/sensor.h"

namespace saccade {
namespace {

TEST(ArtefactOdds, HaveTheirLimits) {
  EXPECT_EQ(artefactOdds(1, 0), 0);
  EXPECT_NEAR(artefactOdds(1e-9, 1), 0.5, 1e-6);
  EXPECT_NEAR(artefactOdds(100, 1), 1 / std::sqrt(2 * std::numbers::pi) / 100, 1e-9);
  EXPECT_EQ(artefactOdds(-0.3, 0.2), artefactOdds(0.3, 0.2));
}

// True changes spread evenly, normal errors: in pixels that seem to change by about dL, the events beyond the
// true change are the false ones.
TEST(ArtefactOdds, AreTheShareOfFalseEvents) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> truths(-6, 6);
  std::normal_distribution<double> errors(0, 1);
  for (const double dL : {0.25, 1.0, 2.5}) {
    double sent = 0, wrong = 0;
    for (int i = 0; i < 2'000'000; ++i) {
      const double truth = truths(random), seen = truth + errors(random);
      if (std::abs(seen - dL) > 0.02) continue;
      sent += seen;
      wrong += std::clamp(seen - truth, 0.0, seen);
    }
    EXPECT_NEAR(wrong / sent, artefactOdds(dL, 1), 0.02) << dL;
  }
}

// Four pixels brighten by 0.5 with errors of 0, 0.05, 0.5 and 5.
class JudgedSensor : public testing::Test {
 protected:
  JudgedSensor() {
    change_.frame = 1;
    change_.t1 = TimeNs(2'000'000);
    change_.I_prev.fill(2);
    change_.dI.fill(2 * std::expm1(0.5f));
    for (int x = 0; x < 4; ++x) change_.var_dI.at(x, 0) = kSigma[x] * kSigma[x] * 4;
  }
  SensorOutput run(const SensorConfig& config) {
    SensorOutput out;
    Sensor(config, 4, 1).generate(change_, out);
    return out;
  }
  static constexpr float kSigma[] = {0, 0.05f, 0.5f, 5};
  const SensorConfig plain_{
      .threshold = 0.1, .threshold_off = 0.1, .bias = 1e-12, .reconstruction = "direct"};
  IntensityChange change_{4, 1};
};

TEST_F(JudgedSensor, LabelsEachEvent) {
  SensorConfig config = plain_;
  config.labels = true;
  const SensorOutput out = run(config);
  EXPECT_EQ(out.suppressed, 0u);
  EXPECT_GE(out.events.size(), 16u);
  for (const Event& event : out.events) {
    EXPECT_NEAR(event.artefact / 255.0, artefactOdds(0.5, kSigma[event.x]), 0.003);
  }
}

TEST_F(JudgedSensor, WithholdsAndCountsLikelyArtefacts) {
  SensorConfig config = plain_;
  config.max_artefact_odds = 0.2;
  const SensorOutput whole = run(plain_), kept = run(config);
  const auto likely =
      std::count_if(whole.events.begin(), whole.events.end(), [](Event e) { return e.x >= 2; });
  EXPECT_EQ(kept.artefacts, static_cast<std::uint64_t>(likely));
  EXPECT_EQ(kept.suppressed, kept.artefacts);
  EXPECT_EQ(kept.events.size() + kept.artefacts, whole.events.size());
  EXPECT_TRUE(std::all_of(kept.events.begin(), kept.events.end(), [](Event e) { return e.x < 2; }));
}

}  // namespace
}  // namespace saccade
