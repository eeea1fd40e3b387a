#include "app/config/nearest_name.h"

#include <gtest/gtest.h>

namespace saccade {
namespace {

TEST(NearestName, TakesTheFewestChanges) {
  const std::vector<std::string> names{"control", "data", "threads", "log-level"};
  EXPECT_EQ(nearestName("thread", names), "threads");       // one letter put in
  EXPECT_EQ(nearestName("controll", names), "control");     // one taken out
  EXPECT_EQ(nearestName("log_level", names), "log-level");  // one replaced
  EXPECT_EQ(nearestName("", names), "data");                // four put in
  EXPECT_EQ(nearestName("data", names), "data");
}

// Counted as taking out and putting in, "ac" were no nearer than "abcd".
TEST(NearestName, CountsAReplacementOnce) {
  EXPECT_EQ(nearestName("ab", {"abcd", "ac"}), "ac");
}

TEST(NearestName, OfEqualsTakesTheFirst) {
  EXPECT_EQ(nearestName("x", {"a", "b"}), "a");
}

}  // namespace
}  // namespace saccade
