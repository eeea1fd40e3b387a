#include "eval/bench/bench_options.h"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <set>
#include <stdexcept>

namespace saccade::eval {
namespace {

BenchOptions resolved(const std::string& size, const std::string& frames, bool quick = false) {
  BenchOptions o;
  o.size = size, o.frames = frames, o.quick = quick;
  o.setup.frame_rate_hz = 250, o.setup.reference_spp = 4096;
  resolve(o);
  return o;
}

TEST(BenchOptions, AreReadFromTheirTexts) {
  const BenchSetup setup = resolved("100x60", "17:21").setup;
  EXPECT_EQ(setup.width, 100);
  EXPECT_EQ(setup.height, 60);
  EXPECT_EQ(setup.first, 17);
  EXPECT_EQ(setup.last, 21);
  EXPECT_EQ(setup.frame_rate_hz, 250);
  EXPECT_EQ(setup.reference_spp, 4096);
  EXPECT_THROW(resolved("100", "17:21"), std::runtime_error);
  EXPECT_THROW(resolved("100x60", "0:21"), std::runtime_error);
}

TEST(BenchOptions, QuickKeepsTheMotionInPixels) {
  const BenchSetup setup = resolved("100x60", "17:21", true).setup;
  EXPECT_EQ(setup.width, 50);
  EXPECT_EQ(setup.height, 30);
  EXPECT_EQ(setup.frame_rate_hz, 125);  // half the pixels per second
  EXPECT_EQ(setup.first, 17);
  EXPECT_EQ(setup.last, 19);
  EXPECT_EQ(setup.reference_spp, 1024);
}

BenchOptions parsed(const std::string& flags) {
  BenchOptions o;
  CLI::App app;
  addBenchOptions(app, o);
  app.parse(flags);
  resolve(o);
  return o;
}

TEST(BenchOptions, QuickLeavesFlagsThatAreGiven) {
  const BenchSetup plain = parsed("--quick").setup;
  EXPECT_EQ(plain.width, 64);
  EXPECT_EQ(plain.frame_rate_hz, 125);
  const BenchSetup size = parsed("--quick --size 64x48").setup;
  EXPECT_EQ(size.width, 64);
  EXPECT_EQ(size.height, 48);
  EXPECT_EQ(size.frame_rate_hz, 250);  // the pixels per second are whole
  EXPECT_EQ(parsed("--quick --rate 500").setup.frame_rate_hz, 500);
  EXPECT_EQ(parsed("--quick --reference 1024").setup.reference_spp, 1024);
  EXPECT_EQ(parsed("--quick --frames 17:21").setup.last, 21);
}

TEST(BenchOptions, TakeTheFlagsOfRecord) {
  EXPECT_EQ(parsed("--motion orbit:10").setup.trajectory, "orbit:10");
  EXPECT_EQ(parsed("--trajectory orbit:10").setup.trajectory, "orbit:10");
}

// Where the command moves the camera, neither the flags nor the text tell a path.
TEST(BenchOptions, LeaveTheCameraToTheCommand) {
  BenchOptions o;
  o.camera = false;
  CLI::App app;
  addBenchOptions(app, o);
  app.parse("--quick");
  resolve(o);
  EXPECT_EQ(o.setup.width, 64);
  EXPECT_EQ(o.setup.last, 21);
  EXPECT_EQ(o.setup.frame_rate_hz, 250);
  for (const char* flag : {"--rate", "--motion", "--frames"})
    EXPECT_EQ(app.get_option_no_throw(flag), nullptr) << flag;
  const std::string text = o.text();
  o.setup.trajectory = "orbit", o.setup.px_per_frame = 3, o.setup.first = 7;
  EXPECT_EQ(o.text(), text);
  EXPECT_NE(text.find(" size=64x64 bounces=3 "), std::string::npos) << text;
}

TEST(BenchOptions, QuickLeavesSomethingToScore) {
  BenchOptions o;
  o.size = "1x1", o.frames = "5", o.quick = true, o.setup.reference_spp = 100;
  resolve(o);
  EXPECT_EQ(o.setup.width, 1);
  EXPECT_EQ(o.setup.height, 1);
  EXPECT_EQ(o.setup.last, 5);
  EXPECT_EQ(o.setup.reference_spp, 64);
}

// Readers compare the rows of a table under one text.
TEST(BenchOptions, TheirTextSaysAllThatChangesAResult) {
  using Change = std::function<void(BenchOptions&)>;
  const std::vector<Change> changes{
      [](BenchOptions&) {},
      [](BenchOptions& o) { o.setup.trajectory = "forward"; },
      [](BenchOptions& o) { o.setup.width = 64; },
      [](BenchOptions& o) { o.setup.height = 64; },
      [](BenchOptions& o) { o.setup.frame_rate_hz = 100; },
      [](BenchOptions& o) { o.setup.px_per_frame = 2; },
      [](BenchOptions& o) { o.setup.px_per_frame = 3; },
      [](BenchOptions& o) { o.setup.bounces = 7; },
      [](BenchOptions& o) { o.setup.first = 7; },
      [](BenchOptions& o) { o.setup.last = 27; },
      [](BenchOptions& o) { o.setup.reference_spp = 64; },
      [](BenchOptions& o) { o.repeats = 3; },
      [](BenchOptions& o) { o.threshold = 0.3; },
      [](BenchOptions& o) { o.bias = 0.1; },
  };
  std::set<std::string> texts;
  for (const Change& change : changes) {
    BenchOptions o;
    change(o);
    texts.insert(o.text());
  }
  EXPECT_EQ(texts.size(), changes.size());
  EXPECT_EQ(texts.begin()->find('\n'), std::string::npos);
}

}  // namespace
}  // namespace saccade::eval
