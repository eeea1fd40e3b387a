#include "log/limited_log.h"

#include <gtest/gtest.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <sstream>

namespace saccade {
namespace {

TEST(LimitedLog, WritesNoMoreThanTheLimitOfOneClient) {
  std::ostringstream text;
  const auto before = spdlog::default_logger();
  spdlog::set_default_logger(
      std::make_shared<spdlog::logger>("test", std::make_shared<spdlog::sinks::ostream_sink_st>(text)));
  LimitedLog log;
  const auto began = LogLimit::Clock::now();
  for (int i = 0; i < 100'000; ++i) log.write(spdlog::level::warn, "a page has gone");
  const auto pauses = (LogLimit::Clock::now() - began) / LogLimit::kPause;
  spdlog::set_default_logger(before);
  const std::string lines = text.str();
  const auto count = std::count(lines.begin(), lines.end(), '\n');
  EXPECT_GE(count, LogLimit::kBurst);
  EXPECT_LE(count, LogLimit::kBurst + 2 * (pauses + 1));  // each with one that counts those before it
  EXPECT_NE(lines.find("a page has gone"), std::string::npos);
}

}  // namespace
}  // namespace saccade
