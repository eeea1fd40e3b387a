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
  return {.name = "cut", .why = "all is new", .bound = 2};
}

MethodFigures figures() {
  return {{"event_svgf", wrong(1)}, {"svgf", wrong(0.95)}, {"pt", wrong(0.5)}};
}

TEST(StabilityTable, NamesTheRivalsThatAreClearlyBetter) {
  EXPECT_EQ(betterThanOurs(cut(), figures()), std::vector<std::string>{"pt"});
  EXPECT_TRUE(betterThanOurs(cut(), {{"event_svgf", wrong(0)}, {"pt", wrong(0)}}).empty());
}

TEST(StabilityTable, SaysInTheTableWhereOursIsWorse) {
  StabilityTable table("quick");
  table.add(cut(), figures());
  EXPECT_NE(table.markdown().find("| cut | wrong_events | 2 | 1 | 0.95 | **0.5** | pt |"), std::string::npos)
      << table.markdown();
  EXPECT_NE(table.markdown().find("- cut: all is new.\n"), std::string::npos);
  EXPECT_NE(table.csv().find("\ncut,wrong_events,2,event_svgf,1,0,0,0,0,-,0,0,0,0\n"), std::string::npos)
      << table.csv();
  EXPECT_NE(table.csv().find("\ncut,wrong_events,2,pt,0.5,0,0,0,0,-,0,0,0,1\n"), std::string::npos);
}

}  // namespace
}  // namespace saccade::test
