#include "base/default_cache.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace saccade {
namespace {

TEST(DefaultCache, IsWhereTheUserKeepsCaches) {
  setenv("HOME", "/nobody", 1);
  setenv("XDG_CACHE_HOME", "/elsewhere", 1);
  EXPECT_EQ(defaultCache(), "/elsewhere/saccade");
  setenv("XDG_CACHE_HOME", "", 1);  // counts as unset
  EXPECT_EQ(defaultCache(), "/nobody/.cache/saccade");
  unsetenv("XDG_CACHE_HOME");
  EXPECT_EQ(defaultCache(), "/nobody/.cache/saccade");
  unsetenv("HOME");
  EXPECT_EQ(defaultCache(), "out/cache");
}

}  // namespace
}  // namespace saccade
