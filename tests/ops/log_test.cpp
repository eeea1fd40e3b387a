#include "ops/log.h"

#include <gtest/gtest.h>
#include <spdlog/spdlog.h>

#include <regex>

namespace saccade {
namespace {

TEST(Log, QuotesWhatJsonForbids) {
  EXPECT_EQ(quoteJson("a \"b\" \\c/"), R"("a \"b\" \\c/")");
  EXPECT_EQ(quoteJson("1\n2\t\x01\x7F"), R"("1\n2\u0009\u0001\u007f")");
  EXPECT_EQ(quoteJson(std::string_view("\0", 1)), R"("\u0000")");
}

TEST(Log, KeepsUtf8AndMarksWhatIsNone) {
  for (const char* text : {"\u00e9", "\u20ac", "\U0001F4F7", "\u07FF\uFFFF"}) {
    EXPECT_EQ(quoteJson(text), '"' + std::string(text) + '"');
  }
  EXPECT_EQ(quoteJson("a\xFFz"), "\"a\uFFFDz\"");
  EXPECT_EQ(quoteJson("\xE2\x82"), "\"\uFFFD\uFFFD\"");               // cut off
  EXPECT_EQ(quoteJson("\xC0\xAF"), "\"\uFFFD\uFFFD\"");               // overlong
  EXPECT_EQ(quoteJson("\xED\xA0\x80"), "\"\uFFFD\uFFFD\uFFFD\"");     // half of a surrogate
  EXPECT_EQ(quoteJson("\xF4\x90\x80\x80").substr(0, 4), "\"\uFFFD");  // beyond U+10FFFF
}

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

}  // namespace
}  // namespace saccade
