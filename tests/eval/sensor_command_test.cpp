// `saccade-eval sensor` as a user runs it, on few pixels.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "client/scratch_folder.h"

namespace saccade::client {
namespace {

struct SensorCommand : testing::Test {
  ScratchFolder folder;

  // The exit code. The output goes to `log`.
  int sensor(const std::string& arguments) {
    const std::string command = std::string(SACCADE_EVAL) + " sensor " + arguments + " -o " +
                                folder.at("out") + " > " + folder.at("log") + " 2>&1";
    return WEXITSTATUS(std::system(command.c_str()));
  }
  std::string text(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(folder.at(name)).rdbuf();
    return text.str();
  }
  void expectSaid(const std::string& part) const {
    EXPECT_NE(text("log").find(part), std::string::npos) << text("log");
  }
};

std::string secondLine(const std::string& text) {
  const std::size_t begin = text.find('\n') + 1;
  return text.substr(begin, text.find('\n', begin) - begin);
}

long linesOf(const std::string& text) {
  return std::count(text.begin(), text.end(), '\n');
}

TEST_F(SensorCommand, WritesEachCurveAsATableAndAPicture) {
  ASSERT_EQ(sensor("--size 8x8 --threshold 0.25 --refractory 0.001"), 0) << text("log");
  const struct {
    std::string name, columns;
    long rows;
  } curves[] = {
      {"threshold",
       "step,on_any_level,off_any_level,on_after_event,off_after_event,on_any_level_expected,"
       "off_any_level_expected,on_after_event_expected,off_after_event_expected",
       50},
      {"noise", "intensity,on_hz,off_hz,on_expected_hz,off_expected_hz", 11},
      {"frequency", "intensity,hz,on_per_cycle,off_per_cycle,gain,expected_gain", 4 * 25},
      {"latency",
       "intensity,on_median_s,on_low_s,on_high_s,on_answered,off_median_s,off_low_s,off_high_s,"
       "off_answered,on_median_expected_s,off_median_expected_s",
       11},
      {"jitter", "frame_rate_hz,error_s,error_expected_s", 10},
      {"readout", "offered_hz,delivered_hz,lost,wait_s,delivered_expected_hz,lost_expected,wait_expected_s",
       24}};
  for (const auto& [name, columns, rows] : curves) {
    const std::string csv = text("out/" + name + ".csv"), svg = text("out/" + name + ".svg");
    EXPECT_EQ(csv.find("# threshold=0.25 threshold_off=0.25 bias=0.001 refractory_s=0.001 size=8x8 "), 0u)
        << csv;
    EXPECT_EQ(secondLine(csv), columns);
    EXPECT_EQ(linesOf(csv), 2 + rows) << name;
    EXPECT_NE(svg.find("</svg>"), std::string::npos) << name;
    EXPECT_EQ(svg.find("nan,"), std::string::npos) << name;  // "luminance" is no number
    EXPECT_EQ(svg.find(",nan"), std::string::npos) << name;
  }
  expectSaid("ON  after an event  50 % at 0.25");
  expectSaid("intensity 1: -3 dB ");
}

TEST_F(SensorCommand, MakesTheCurvesAskedFor) {
  ASSERT_EQ(sensor("--size 4x4 --curves noise"), 0) << text("log");
  EXPECT_TRUE(std::filesystem::exists(folder.at("out/noise.csv")));
  EXPECT_FALSE(std::filesystem::exists(folder.at("out/latency.csv")));
}

TEST_F(SensorCommand, TakesSettingsOfTheNoise) {
  ASSERT_EQ(sensor("--size 4x4 --curves noise --noise leak_hz=0.5 --noise shot_hz=2"), 0) << text("log");
  EXPECT_NE(text("out/noise.csv").find(" leak_hz=0.5 shot_hz=2 "), std::string::npos);
}

// Flags win over the preset; noise that is not given stays that of the preset.
TEST_F(SensorCommand, TakesAPreset) {
  ASSERT_EQ(sensor("--size 4x4 --curves noise --preset v2e-noisy --threshold-off 0.3 --noise leak_hz=0"), 0)
      << text("log");
  const std::string csv = text("out/noise.csv");
  EXPECT_EQ(csv.find("# threshold=0.3 threshold_off=0.3 bias=0.001 refractory_s=0 "), 0u) << csv;
  EXPECT_NE(csv.find(" leak_hz=0 shot_hz=5 "), std::string::npos) << csv;
}

TEST_F(SensorCommand, WithoutAPresetTheThresholdOfOffEventsIsItsOwn) {
  ASSERT_EQ(sensor("--size 4x4 --curves noise --threshold-off 0.3"), 0) << text("log");
  EXPECT_EQ(text("out/noise.csv").find("# threshold=0.2 threshold_off=0.3 "), 0u);
}

TEST_F(SensorCommand, RefusesWrongFlags) {
  EXPECT_EQ(sensor("--preset eye"), 2);
  expectSaid("there is no \"eye\"; there are: davis346, ");
  EXPECT_EQ(sensor("--curves speed"), 2);
  expectSaid("there is no \"speed\"; there are: threshold, noise, frequency, latency, jitter, readout");
  EXPECT_EQ(sensor("--noise leak=1"), 2);
  expectSaid("must be KEY=VALUE, not leak=1; the keys are mismatch, ");
  EXPECT_EQ(sensor("--noise leak_hz=much"), 2);
  expectSaid("leak_hz=much: the value must be a number");
  EXPECT_EQ(sensor("--noise leak_hz=-1"), 1);
  expectSaid("noise.leak_hz: -1 is outside");
  EXPECT_EQ(sensor("--threshold 0"), 2);
}

}  // namespace
}  // namespace saccade::client
