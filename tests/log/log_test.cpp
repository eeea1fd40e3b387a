#include "log/log.h"

#include <gtest/gtest.h>
#include <spdlog/spdlog.h>

#include <regex>

namespace saccade {
namespace {

TEST(Log, JsonIsOneObjectInEachLine) {
  testing::internal::CaptureStdout();
  setUpLog("info", "json");
  spdlog::debug("not told");
  spdlog::warn("two\nlines, \"quoted\"");
  finishLog();
  const std::string line = testing::internal::GetCapturedStdout();
  const std::regex pattern(R"(\{"time":"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\.\d{3}Z","level":"warning",)"
                           R"("message":"two\\nlines, \\"quoted\\""\}\n)");
  EXPECT_TRUE(std::regex_match(line, pattern)) << line;
}

// A message that holds what looks like a line of the log, and commands for a terminal.
TEST(Log, TextIsOneLineForEachMessage) {
  testing::internal::CaptureStdout();
  setUpLog("info", "text");
  spdlog::info("closed 'x'\n[2026-11-22 05:00:00.000] [critical] forged\x1B[31m");
  EXPECT_TRUE(finishLog());
  const std::string line = testing::internal::GetCapturedStdout();
  const std::regex pattern(R"(\[\d{4}-\d\d-\d\d \d\d:\d\d:\d\d\.\d{3}\] \[info\] closed 'x'\\n)"
                           R"(\[2026-11-22 05:00:00.000\] \[critical\] forged\\u001b\[31m\n)");
  EXPECT_TRUE(std::regex_match(line, pattern)) << line;
}

}  // namespace
}  // namespace saccade
