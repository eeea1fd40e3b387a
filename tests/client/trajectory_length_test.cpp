#include "client/commands/trajectory_length.h"

#include <gtest/gtest.h>

namespace saccade::client {
namespace {

TEST(TrajectoryLength, APathThatFillsItsStreamIsRight) {
  EXPECT_EQ(trajectoryWarning(2, 2), "");
  EXPECT_EQ(trajectoryWarning(1, 0), "");
}

TEST(TrajectoryLength, AShorterOneIsTold) {
  EXPECT_EQ(trajectoryWarning(1.5, 2),
            "the trajectory lasts 1.5 s, the stream 2 s: then the camera stands still");
}

TEST(TrajectoryLength, OnePoseIsTold) {
  EXPECT_EQ(trajectoryWarning(0, 2), "the trajectory has one pose: the camera does not move");
  EXPECT_EQ(trajectoryWarning(0, 0), "the trajectory has one pose: the camera does not move");
}

TEST(TrajectoryLength, TheWrongUnitIsTold) {
  const std::string units =
      "; without a heading that names the unit, times are nanoseconds between commas and seconds between "
      "blanks";
  EXPECT_EQ(trajectoryWarning(1e-9, 0.02),
            "the trajectory lasts 1 ns, the stream 0.02 s: then the camera stands still" + units);
  EXPECT_EQ(trajectoryWarning(2e9, 2), "the trajectory lasts 2e+09 s" + units);
}

}  // namespace
}  // namespace saccade::client
