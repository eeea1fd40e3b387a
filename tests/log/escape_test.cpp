#include "log/escape.h"

#include <gtest/gtest.h>

namespace saccade {
namespace {

TEST(Escape, QuotesWhatJsonForbids) {
  EXPECT_EQ(quoteJson("a \"b\" \\c/"), R"("a \"b\" \\c/")");
  EXPECT_EQ(quoteJson("1\n2\t\x01\x7F"), R"("1\n2\u0009\u0001\u007f")");
  EXPECT_EQ(quoteJson(std::string_view("\0", 1)), R"("\u0000")");
}

TEST(Escape, KeepsUtf8AndMarksWhatIsNone) {
  for (const char* text : {"\u00e9", "\u20ac", "\U0001F4F7", "\u07FF\uFFFF"}) {
    EXPECT_EQ(quoteJson(text), '"' + std::string(text) + '"');
  }
  EXPECT_EQ(quoteJson("a\xFFz"), "\"a\uFFFDz\"");
  EXPECT_EQ(quoteJson("\xE2\x82"), "\"\uFFFD\uFFFD\"");               // cut off
  EXPECT_EQ(quoteJson("\xC0\xAF"), "\"\uFFFD\uFFFD\"");               // overlong
  EXPECT_EQ(quoteJson("\xED\xA0\x80"), "\"\uFFFD\uFFFD\uFFFD\"");     // half of a surrogate
  EXPECT_EQ(quoteJson("\xF4\x90\x80\x80").substr(0, 4), "\"\uFFFD");  // beyond U+10FFFF
}

TEST(Escape, LeavesNoControlCharacter) {
  EXPECT_EQ(escapeControls("1\n2\r\x1B[31m\x7F\x07"), "1\\n2\\u000d\\u001b[31m\\u007f\\u0007");
  EXPECT_EQ(escapeControls("\u0080\u009B\u00A0"), "\\u0080\\u009b\u00A0");  // of the second set, and no more
  EXPECT_EQ(escapeControls("a \"b\" \\ \u20ac \xFF"), "a \"b\" \\ \u20ac \uFFFD");
  EXPECT_EQ(escapeControls(std::string_view("\0", 1)), "\\u0000");
}

}  // namespace
}  // namespace saccade
