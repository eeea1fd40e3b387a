#include "stability/verdict.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "events/sensor_config.h"
#include "methods/method.h"

namespace saccade::test {
namespace {

// The rivals of all methods but the default. Later methods are better in many cases, for reasons that
// server/methods/RIVALS.md gives.
const std::vector<std::string> kRivals{"event_svgf", "svgf", "svgf:as_falcor=1", "pt-correlated", "pt"};

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Every method is a rival of the default: users who choose none must not lose by it.
bool isRival(const std::string& other, const std::string& method) {
  return method == defaultMethod(true).name || contains(kRivals, other);
}

}  // namespace

void expectSound(const StabilityCase& c, const MethodFigures& figures) {
  for (const auto& [method, f] : figures) {
    EXPECT_EQ(f.non_finite, 0) << method;
    EXPECT_LE(f.events, SensorConfig{}.max_events_per_pixel_frame) << method;
    if (c.suppresses) {
      EXPECT_GT(f.suppressed, 0) << method;
    }
  }
}

void expectKept(const Claim& claim, const StabilityCase& c, const MethodFigures& figures) {
  EXPECT_LE(figuresOf(claim.method, figures).*c.judged, claim.bound) << claim.method;
  for (const std::string& better : betterThan(claim.method, c, figures)) {
    if (isRival(better, claim.method)) {
      EXPECT_TRUE(contains(claim.beaten_by, better))
          << better << " is clearly better than " << claim.method << "; the case gives no reason";
    }
  }
}

void expectNoWorse(const Claim& claim, const StabilityCase& c, const MethodFigures& figures,
                   const MethodFigures& before) {
  for (const auto figure : {&Figures::wrong_events, c.judged}) {
    const double was = figuresOf(claim.method, before).*figure;
    EXPECT_LE(figuresOf(claim.method, figures).*figure, claim.lap_ratio * was)
        << claim.method << " is worse than a lap before";
  }
}

}  // namespace saccade::test
