#include "base/text_cut.h"

#include <gtest/gtest.h>

namespace saccade {
namespace {

TEST(CutText, LeavesWhatFits) {
  EXPECT_EQ(cutText("", 0), "");
  EXPECT_EQ(cutText("abc", 3), "abc");
  EXPECT_EQ(cutText("a€", 4), "a€");
}

TEST(CutText, CutsBetweenCharacters) {
  EXPECT_EQ(cutText("abcd", 3), "abc...");
  for (const std::size_t bytes : {3, 4, 5}) EXPECT_EQ(cutText("€€", bytes), "€...") << bytes;
  EXPECT_EQ(cutText("€", 2), "...");
}

TEST(CutText, ReplacesWhatIsNoUtf8) {
  EXPECT_EQ(cutText("\xFF\xFE", 6), "\uFFFD\uFFFD");
  EXPECT_EQ(cutText("a\xC3", 10), "a\uFFFD");  // the rest of the character is gone
  EXPECT_EQ(cutText("\xFF\xFF", 5), "\uFFFD...");
}

// For any bytes, and any place of the cut.
TEST(CutText, IsAlwaysUtf8) {
  const std::string bytes =
      "a\xE2\x82\xAC\xC3\xA9\xF0\x9F\x98\x80\xED\xA0\x80\xC0\x80\xF4\x90\x80\x80\xE2\x82";
  for (std::size_t first = 0; first < bytes.size(); ++first) {
    for (std::size_t most = 0; most < 40; ++most) {
      const std::string cut = cutText(std::string_view(bytes).substr(first), most);
      EXPECT_TRUE(isUtf8(cut)) << first << " " << most;
      EXPECT_LE(cut.size(), most + 3);
    }
  }
}

TEST(Utf8, IsKnownByItsBytes) {
  EXPECT_TRUE(isUtf8("é€\U0001F600"));
  for (const char* bytes : {"\xC0\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\x80", "\xE2\x82", "\xFF"})
    EXPECT_FALSE(isUtf8(bytes)) << bytes;
}

}  // namespace
}  // namespace saccade
