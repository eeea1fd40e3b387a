#include "stability/table.h"

#include <gtest/gtest.h>

#include <limits>

namespace saccade::test {
namespace {

Figures wrong(double events) {
  Figures f{};
  f.wrong_events = events;
  f.drift = std::numeric_limits<double>::quiet_NaN();
  return f;
}

StabilityCase cut() {
  return {.name = "cut",
          .why = "all is new",
          .claims = {{"event_svgf", 2, {"pt"}, "it has to guess"}, {"svgf", 3}}};
}

MethodFigures figures() {
  return {{"event_svgf", wrong(1)}, {"svgf", wrong(0.95)}, {"pt", wrong(0.5)}};
}

TEST(StabilityTable, NamesTheMethodsThatAreClearlyBetter) {
  EXPECT_EQ(betterThan("event_svgf", cut(), figures()), std::vector<std::string>{"pt"});
  EXPECT_TRUE(betterThan("pt", cut(), {{"event_svgf", wrong(0)}, {"pt", wrong(0)}}).empty());
}

TEST(StabilityTable, KnowsWhatACaseClaims) {
  const StabilityCase c = cut();
  EXPECT_EQ(claimOf(c, "svgf"), &c.claims[1]);
  EXPECT_EQ(claimOf(c, "pt"), nullptr);
}

TEST(StabilityTable, SaysWhoLosesToWhomAndWhy) {
  StabilityTable table("quick");
  table.add(cut(), figures());
  EXPECT_NE(
      table.markdown().find("| cut | wrong_events | 1 ≤ 2 | 0.95 ≤ 3 | **0.5** | event_svgf: pt; svgf: pt |"),
      std::string::npos)
      << table.markdown();
  EXPECT_NE(table.markdown().find("- cut: all is new. event_svgf: it has to guess.\n"), std::string::npos);
  EXPECT_NE(table.csv().find("\ncut,wrong_events,event_svgf,2,1,0,0,0,0,-,0,0,0,pt\n"), std::string::npos)
      << table.csv();
  EXPECT_NE(table.csv().find("\ncut,wrong_events,pt,-,0.5,0,0,0,0,-,0,0,0,\n"), std::string::npos);
}

}  // namespace
}  // namespace saccade::test
