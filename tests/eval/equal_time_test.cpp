#include "eval/bench/equal_time.h"

#include <gtest/gtest.h>

#include "eval/figures/equal_time_rows.h"
#include "saccade/wire/ranges.h"

namespace saccade::eval {
namespace {

// Measures a method whose frame takes fixed + slope n.
struct Clock {
  double fixed, slope;
  std::vector<int> asked = {};
  int within(double budget, int step, std::map<int, double> known = {}) {
    return pathsWithin(budget, step, known, [this](int n) {
      asked.push_back(n);
      return fixed + slope * n;
    });
  }
};

TEST(PathsWithin, FindsTheMostPathsThatFit) {
  for (const double budget : {3.0, 7.7, 20.0, 500.0, 12345.0}) {
    for (const int step : {1, 2}) {
      Clock clock{2, 0.5};
      const int found = clock.within(budget, step);
      const int most = static_cast<int>((budget - 2) / 0.5) / step * step;
      EXPECT_LE(found, most) << budget;
      EXPECT_TRUE(found == most || 2 + 0.5 * found >= kClose * budget) << budget << ": " << found;
      EXPECT_EQ(found % step, 0);
      EXPECT_LE(clock.asked.size(), static_cast<std::size_t>(kTries));
    }
  }
}

TEST(PathsWithin, KnowsWhatIsMeasured) {
  Clock clock{0, 1};
  EXPECT_EQ(clock.within(32, 1, {{1, 1.0}, {32, 31.0}, {128, 128.0}}), 32);
  EXPECT_TRUE(clock.asked.empty());
}

TEST(PathsWithin, IsZeroWhereTheLeastTakesLonger) {
  Clock clock{10, 1};
  EXPECT_EQ(clock.within(11.5, 2), 0);
  EXPECT_EQ(clock.asked, std::vector<int>{2});
  EXPECT_EQ(clock.within(11.5, 2, {{8, 18.0}}), 0);
}

TEST(PathsWithin, EndsAtTheMostPathsThatARequestMayHave) {
  Clock clock{0, 0};
  EXPECT_LE(clock.within(1, 1, {{ranges::kSpp.max, 0.1}}), ranges::kSpp.max);
  EXPECT_TRUE(clock.asked.empty());
}

EqualTimeRow row(const char* method, double budget, int spp, double false_events, double missed_events) {
  EqualTimeRow row{"box", method, budget, 5 * budget, {}};
  row.result.spp = spp, row.result.cpu_ms = 4 * budget;
  row.result.score.false_events = false_events, row.result.score.missed_events = missed_events;
  return row;
}

TEST(EqualTimeRows, RankMethodsByWrongEvents) {
  const std::vector<EqualTimeRow> rows{row("a", 1, 2, 0.5, 0.25), row("a", 4, 8, 0.25, 0.125),
                                       row("b", 1, 0, 0, 0),      row("b", 4, 2, 0.125, 0.125),
                                       row("c", 1, 4, 0.5, 0.5),  row("c", 4, 16, 0.5, 0.125)};
  EXPECT_EQ(markdownOf(rows),
            "| scene | 1 times | 4 times |\n|---|---|---|\n"
            "| box | `a@2` 0.750, then `c@4` 1.000 | `b@2` 0.250, then `a@8` 0.375 |\n");
  const std::string text = textOf(rows), csv = csvOf(rows);
  EXPECT_NE(text.find("box, 4 times the time of two paths: 20 CPU ms per frame\n"), text.npos) << text;
  EXPECT_LT(text.find("b                          2   0.80"),
            text.find("a                          8   0.80"));
  EXPECT_NE(text.find("b                      nothing fits"), text.npos) << text;
  EXPECT_NE(csv.find("\nbox,4,20,b,2,0.8,"), csv.npos) << csv;
  EXPECT_NE(csv.find("\nbox,1,5,b,0,,"), csv.npos) << csv;
}

}  // namespace
}  // namespace saccade::eval
