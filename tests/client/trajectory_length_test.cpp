#include "client/commands/trajectory_length.h"

#include <gtest/gtest.h>

namespace saccade::client {
namespace {

constexpr double kFrame = 0.01;

TEST(TrajectoryLength, APathThatFillsItsStreamIsRight) {
  EXPECT_EQ(trajectoryWarning(2, 2, kFrame), "");
  EXPECT_EQ(trajectoryWarning(2.009, 2, kFrame), "");
}

TEST(TrajectoryLength, AShorterOneIsTold) {
  EXPECT_EQ(trajectoryWarning(1.5, 2, kFrame),
            "the trajectory lasts 1.5 s, the stream 2 s: then the camera stands still");
  EXPECT_EQ(trajectoryWarning(1.5, 0, kFrame),
            "the trajectory lasts 1.5 s, the stream has no end: then the camera stands still");
}

TEST(TrajectoryLength, ALongerOneIsTold) {
  EXPECT_EQ(trajectoryWarning(2.02, 2, kFrame),
            "the trajectory lasts 2.02 s, the stream 2 s: the rest of the path is left out");
}

TEST(TrajectoryLength, OnePoseIsTold) {
  EXPECT_EQ(trajectoryWarning(0, 2, kFrame), "the trajectory has one pose: the camera does not move");
  EXPECT_EQ(trajectoryWarning(0, 0, kFrame), "the trajectory has one pose: the camera does not move");
}

TEST(TrajectoryLength, TheWrongUnitIsTold) {
  const std::string units =
      "; without a heading that names the unit, times are nanoseconds between commas and seconds between "
      "blanks";
  EXPECT_EQ(trajectoryWarning(1e-9, 0.02, kFrame),
            "the trajectory lasts 1 ns, the stream 0.02 s: then the camera stands still" + units);
  EXPECT_EQ(trajectoryWarning(2e9, 2, kFrame), "the trajectory lasts 2e+09 s" + units);
}

}  // namespace
}  // namespace saccade::client
