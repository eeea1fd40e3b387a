#include "farm/engines/text.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace saccade::farm {
namespace {

TEST(Filled, PutsValuesInPlaceOfKeysOnce) {
  const std::map<std::string, std::string> values{{"A", "@B@"}, {"B", "2"}};
  EXPECT_EQ(filled("@A@@B@ USR1@@B@ ${x[@]} @C@ a@", values), "@B@2 USR1@2 ${x[@]} @C@ a@");
}

TEST(ShellWord, IsOneWordWhateverIsInIt) {
  EXPECT_EQ(shellWord("a b"), "'a b'");
  EXPECT_EQ(shellWord("it's; $(rm x) `y` \"\n"), "'it'\\''s; $(rm x) `y` \"\n'");
  EXPECT_EQ(shellWords({"--scenes", "a b"}), " '--scenes' 'a b'");
  EXPECT_EQ(shellWords({}), "");
}

TEST(Quoted, EscapesQuotesAndBackslashes) {
  EXPECT_EQ(quoted("a\"b\\c'{d}"), "\"a\\\"b\\\\c'{d}\"");
}

TEST(CheckPlain, TakesTextAndRefusesTheRest) {
  for (const char* text : {"a", "a b", "ä€𝄞", "'\";$(x)"}) EXPECT_NO_THROW(checkPlain(text, "--x")) << text;
  for (const char* text : {"", "a\nb", "a\tb", "\x7f", "\xff", "\xc3", "\xe2\x82", "\xc3("})
    EXPECT_THROW(checkPlain(text, "--x"), std::invalid_argument) << text;
}

}  // namespace
}  // namespace saccade::farm
