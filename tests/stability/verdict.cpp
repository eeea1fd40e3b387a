#include "stability/verdict.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "events/sensor_config.h"

namespace saccade::test {
namespace {

// The rivals of claims. Further methods of the table have figures and no say, see server/methods/RIVALS.md.
const std::vector<std::string> kRivals{"event_svgf", "svgf", "svgf:as_falcor=1", "pt-correlated", "pt"};

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
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
    if (contains(kRivals, better)) {
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
