#include "scene/files/slow_load.h"

#include <gtest/gtest.h>

namespace saccade {
namespace {

using namespace std::chrono_literals;

TEST(SlowLoad, IsToldOfEveryTwoSeconds) {
  std::chrono::steady_clock::time_point now{5s};
  std::vector<std::string> told;
  const LoadProgress progress = tellSlowLoad(
      "kitchen", [&](const std::string& text) { told.push_back(text); }, [&] { return now; });
  for (int done = 1; done <= 10; ++done) {  // one file in 600 ms
    now += 600ms;
    progress(done, 10);
  }
  EXPECT_EQ(told, (std::vector<std::string>{"kitchen: 4 of 10 files read", "kitchen: 8 of 10 files read"}));
}

TEST(SlowLoad, AQuickLoadIsNotToldOf) {
  std::chrono::steady_clock::time_point now{};
  const LoadProgress progress = tellSlowLoad(
      "box", [](const std::string&) { FAIL(); }, [&] { return now; });
  now += 2s - 1ns;
  progress(8, 8);
}

}  // namespace
}  // namespace saccade
