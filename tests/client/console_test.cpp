#include "client/terminal/console.h"

#include <gtest/gtest.h>

namespace saccade::client {
namespace {

TEST(Console, ControlCharactersBecomeEscapes) {
  EXPECT_EQ(printable("a\x1b[2J\nb\r\t\x7f"), "a\\u001b[2J\\nb\\u000d\\u0009\\u007f");
  EXPECT_EQ(printable(std::string("\0", 1)), "\\u0000");
  EXPECT_EQ(printable("\xc2\x9b"
                      "2J\xc2\x80"),
            "\\u009b2J\\u0080");  // as of one character
}

TEST(Console, OtherTextIsLeftAsItIs) {
  for (const std::string text : {"", "a b", "\xc3\xa4\xe2\x82\xac", "\xc2\xa0", "\xc2", "\\n", "%s"})
    EXPECT_EQ(printable(text), text);
}

TEST(Console, PrintKeepsTheEndsOfItsLines) {
  testing::internal::CaptureStdout();
  print("%s has %d\n", "\x1b]0;title\x07", 3);
  print(stdout, "%s\n", std::string(10'000, 'x').c_str());
  EXPECT_EQ(testing::internal::GetCapturedStdout(),
            "\\u001b]0;title\\u0007 has 3\n" + std::string(10'000, 'x') + "\n");
}

}  // namespace
}  // namespace saccade::client
