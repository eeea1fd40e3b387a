#include "eval/bench/ratios.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "eval/compared.h"

namespace saccade::eval {
namespace {

using test::column, test::comparedCell, test::result;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(RatioOf, IsToTheBetterBaselineOfEachColumn) {
  std::vector<Result> baselines{result("a", 4), result("b", 5)};
  baselines[1].score.sigma_dL = 2;
  const Result candidate = result("new", 3);
  for (const ComparedColumn& c : kComparedColumns) {
    const Ratio ratio = ratioOf(candidate, baselines, c);
    const bool is_b = std::string(c.name) == "sigma_dL";
    EXPECT_EQ(ratio.value, is_b ? 1.5 : 0.75) << c.name;
    EXPECT_EQ(ratio.baseline, &baselines[is_b]) << c.name;
    EXPECT_EQ(ratio.mark, Mark::kNone) << c.name;
  }
}

TEST(RatioOf, ReadsEachColumn) {
  Result r = result("x", 0);
  double next = 0;
  for (double* figure :
       {&r.cpu_ms, &r.score.dI_l1, &r.score.dI_error, &r.score.dL_l1, &r.score.dL_error,
        &r.score.false_events, &r.score.missed_events, &r.score.sigma_dL, &r.score.phase_error})
    *figure = ++next;
  next = 0;
  for (const ComparedColumn& c : kComparedColumns) EXPECT_EQ(c.of(r), ++next) << c.name;
}

struct Marked {
  double candidate, baseline;
  Mark mark;
  double value;
};

TEST(RatioOf, MarksWhatDoesNotCount) {
  const Marked cases[] = {{1, 2, Mark::kNone, 0.5},        {1, 0, Mark::kNoBase, kNaN},
                          {0, 0, Mark::kNoBase, kNaN},     {1, -2, Mark::kNoBase, kNaN},
                          {0, 2, Mark::kNothing, 0},       {-1, 2, Mark::kNothing, 0},
                          {kNaN, 2, Mark::kUnknown, kNaN}, {kInfinity, 2, Mark::kUnknown, kNaN},
                          {1, kNaN, Mark::kUnknown, kNaN}, {1, kInfinity, Mark::kUnknown, kNaN}};
  for (const Marked& c : cases) {
    const std::vector<Result> baselines{result("old", c.baseline)};
    const Ratio ratio = ratioOf(result("new", c.candidate), baselines, column("dL_l1"));
    EXPECT_EQ(ratio.mark, c.mark) << c.candidate << " / " << c.baseline;
    if (std::isnan(c.value))
      EXPECT_TRUE(std::isnan(ratio.value)) << c.candidate << " / " << c.baseline;
    else
      EXPECT_EQ(ratio.value, c.value) << c.candidate << " / " << c.baseline;
    EXPECT_EQ(ratio.mark == Mark::kNone, std::string(textOf(ratio.mark)).empty());
  }
}

TEST(RatioOf, PassesOverABaselineThatIsUnknown) {
  const std::vector<Result> baselines{result("a", kNaN), result("b", 5)};
  EXPECT_EQ(ratioOf(result("new", 1), baselines, column("dL_l1")).value, 0.2);
}

// The truth's own error of dI is 0.1, and it has 0.01 false events, and as many missed ones, of its own.
TEST(RatioOf, MarksBaselinesThatTheTruthCannotTell) {
  const auto ratio = [](const char* name, double baseline) {
    const std::vector<Result> baselines{result("old", baseline)};
    return ratioOf(result("new", 0.05), baselines, column(name));
  };
  EXPECT_EQ(ratio("dI_l1", 0.31).mark, Mark::kNone);
  EXPECT_EQ(ratio("dI_l1", 0.29).mark, Mark::kNoise);
  EXPECT_DOUBLE_EQ(ratio("dI_l1", 0.25).value, 0.2);  // told, but not counted
  for (const char* events : {"false_events", "missed_events"}) {
    EXPECT_EQ(ratio(events, 0.031).mark, Mark::kNone);
    EXPECT_EQ(ratio(events, 0.029).mark, Mark::kNoise);
  }
  for (const char* noise_free : {"dL_l1", "dL_error", "dI_error", "sigma_dL"})
    EXPECT_EQ(ratio(noise_free, 0.001).mark, Mark::kNone) << noise_free;
}

TEST(Summarize, IsTheGeometricMeanOfWhatCounts) {
  ComparedCell left_out{{"box", "right", 9, {21, 21}}};
  left_out.left_out = "nothing in view";
  std::vector<ComparedCell> cells;
  cells.push_back(comparedCell(0.1, 2, 1));
  cells.push_back(comparedCell(0.33, 1, 4));
  cells.push_back(comparedCell(0.67, 0, 1));
  cells.push_back(std::move(left_out));
  cells.push_back(comparedCell(2, 4, 1));
  const RatioSummary s = summarize(cells, 0, column("dL_l1"));
  EXPECT_NEAR(s.mean, std::cbrt(0.5 * 4 * 0.25), 1e-12);
  EXPECT_EQ(s.counted, 3);
  EXPECT_EQ(s.marked, 1);
  EXPECT_EQ(s.largest, 4);
  EXPECT_EQ(s.largest_in, "box right 0.33px 21");
}

TEST(Summarize, OfNothingIsUnknown) {
  const RatioSummary s = summarize({comparedCell(2, 0, 1)}, 0, column("dL_l1"));
  EXPECT_TRUE(std::isnan(s.mean));
  EXPECT_TRUE(std::isnan(s.largest));
  EXPECT_EQ(s.counted, 0);
  EXPECT_EQ(s.marked, 1);
  EXPECT_EQ(s.largest_in, "");
}

}  // namespace
}  // namespace saccade::eval
