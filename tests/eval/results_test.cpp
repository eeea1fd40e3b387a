#include "eval/bench/results.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>

namespace saccade::eval {
namespace {

struct Fixture : ::testing::Test {
  Fixture() { std::filesystem::remove_all(folder); }
  std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) /
      (std::string("results_") + testing::UnitTest::GetInstance()->current_test_info()->name());
  std::string path = (folder / "results.csv").string();
};

Result makeResult() {
  Result r{"box", "svgf:alpha=0.2", 4, 12.5, 10, {12.5, 4, 3}, 0.67, 0.05, 0.002, {}, {}};
  r.seed_error.dI_l1 = 0.0625;
  r.score.dI_l1 = 0.25;
  r.score.dI_mape = std::numeric_limits<double>::infinity();  // where the truth stands still
  r.score.time_error_ms = 0.125;
  return r;
}

TEST_F(Fixture, RowsOfAnEarlierRunAreRead) {
  ResultTable(path, "128x128").add(makeResult());
  const ResultTable table(path, "128x128");
  ASSERT_EQ(table.rows().size(), 1u);
  EXPECT_NE(table.find("box", "svgf:alpha=0.2", 4), nullptr);
  EXPECT_EQ(table.find("box", "svgf", 4), nullptr);
  EXPECT_EQ(table.rows()[0].cpu_ms, 12.5);
  EXPECT_EQ(table.rows()[0].reference_events, 0.002);
  EXPECT_EQ(table.rows()[0].time.small_ms, 4);
  EXPECT_EQ(table.rows()[0].time.small_late_ms, 3);
  EXPECT_EQ(table.rows()[0].score.dI_l1, 0.25);
  EXPECT_EQ(table.rows()[0].seed_error.dI_l1, 0.0625);
  EXPECT_EQ(table.rows()[0].score.dI_mape, std::numeric_limits<double>::infinity());
  EXPECT_EQ(table.rows()[0].score.time_error_ms, 0.125);
}

// The server takes a file for a table, and other flags would be refused because of it.
TEST_F(Fixture, WithoutRowsThereIsNoFile) {
  { ResultTable(path, "128x128"); }
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(Fixture, AFileWithoutRowsIsReplaced) {
  ResultTable(path, "64x64").add(makeResult());
  std::string settings, names;
  {
    std::ifstream file(path);
    std::getline(file, settings), std::getline(file, names);
  }
  std::ofstream(path) << settings << '\n' << names << '\n';
  ResultTable(path, "128x128").add(makeResult());
  EXPECT_EQ(ResultTable(path, "128x128").rows().size(), 1u);
}

TEST_F(Fixture, RowsOfOtherSettingsAreNotMixedIn) {
  ResultTable(path, "128x128").add(makeResult());
  try {
    ResultTable(path, "64x64");
    FAIL();
  } catch (const std::runtime_error& fault) {
    for (const std::string& told : {path, std::string("128x128"), std::string("64x64"), std::string("-o")})
      EXPECT_NE(std::string(fault.what()).find(told), std::string::npos) << told;
  }
}

// Rows from before a column was added would be read into the wrong columns.
TEST_F(Fixture, RowsOfOtherColumnsAreNotRead) {
  ResultTable(path, "128x128").add(makeResult());
  std::string text;
  std::getline(std::ifstream(path), text, '\0');
  const std::string newest = std::string(",") + kScoreColumns.back().name;
  text.erase(text.find(newest), newest.size());
  std::ofstream(path) << text;
  try {
    ResultTable(path, "128x128");
    FAIL();
  } catch (const std::runtime_error& fault) {
    EXPECT_NE(std::string(fault.what()).find("has other columns"), std::string::npos);
  }
}

TEST_F(Fixture, AHalfWrittenRowIsNamed) {
  ResultTable(path, "128x128").add(makeResult());
  std::ofstream(path, std::ios::app) << "box,pt,4,1.5";
  try {
    ResultTable(path, "128x128");
    FAIL();
  } catch (const std::runtime_error& fault) {
    EXPECT_NE(std::string(fault.what()).find("box,pt,4,1.5"), std::string::npos);
  }
}

TEST_F(Fixture, RowsOfAnEarlierRunAreNotMeasuredAgain) {
  TilePool pool(2);
  const Bench bench({.scene = "cornell-box",
                     .width = 16,
                     .height = 12,
                     .bounces = 0,
                     .first = 1,
                     .last = 1,
                     .reference_spp = 64,
                     .cache = (folder / "cache").string()},
                    pool);
  ResultTable table(path, "16x12");
  BenchOptions o;
  o.repeats = 2;
  Result stands = makeResult();
  stands.method = "pt", stands.spp = 1;
  table.add(stands);
  const MethodSpec pt = parseMethod("pt");
  EXPECT_EQ(measure(bench, "box", pt, 1, o, table).score.dI_l1, stands.score.dI_l1);
  EXPECT_EQ(table.rows().size(), 1u);

  const Result measured = measure(bench, "box", pt, 2, o, table);
  EXPECT_EQ(table.rows().size(), 2u);
  EXPECT_GT(measured.cpu_ms, measured.trace_ms);
  EXPECT_EQ(measured.px_per_frame, bench.medianPxPerFrame());
  EXPECT_EQ(measured.reference_error, bench.referenceError());
  EXPECT_EQ(measured.reference_events, ownFalseEvents(bench.truth(), o.bias, o.threshold));
  EXPECT_GT(measured.score.noise_dL, 0);  // known by the repeats

  // The standard error of two values is half their distance.
  const auto ofSeed = [&](std::uint64_t seed) {
    const BenchRun run = bench.run(pt, 2, seed);
    return scoreOf(bench.truth(), std::span(&run, 1), o.bias, o.threshold).dI_l1;
  };
  EXPECT_NEAR(measured.seed_error.dI_l1, std::abs(ofSeed(1) - ofSeed(2)) / 2, 1e-12);
}

}  // namespace
}  // namespace saccade::eval
