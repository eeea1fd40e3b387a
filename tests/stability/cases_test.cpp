#include "stability/cases.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace saccade::test {
namespace {

bool claims(const StabilityCase& c, const std::string& method) {
  return std::any_of(c.claims.begin(), c.claims.end(),
                     [&](const Claim& some) { return some.method == method; });
}

class StabilityCases : public ::testing::TestWithParam<bool> {};

TEST_P(StabilityCases, ClaimSomethingOfBothOfOurMethods) {
  for (const StabilityCase& c : stabilityCases(GetParam()))
    for (const char* ours : {"event_svgf", "irradiance_cache"})
      EXPECT_TRUE(claims(c, ours)) << ours << " in " << c;
}

TEST_P(StabilityCases, GiveAReasonForEveryLoss) {
  for (const StabilityCase& c : stabilityCases(GetParam()))
    for (const Claim& claim : c.claims)
      EXPECT_EQ(claim.beaten_by.empty(), !*claim.why) << claim.method << " in " << c;
}

TEST_P(StabilityCases, HaveRoomForTheLapBefore) {
  for (const StabilityCase& c : stabilityCases(GetParam())) {
    if (c.lap == 0) continue;
    EXPECT_GE(c.lap, c.scored) << c;
    EXPECT_GE(lapBefore(c).last, c.scored) << c;
  }
}

INSTANTIATE_TEST_SUITE_P(Forms, StabilityCases, ::testing::Bool());

}  // namespace
}  // namespace saccade::test
