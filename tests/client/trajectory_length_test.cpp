#include "client/commands/trajectory_length.h"

#include <gtest/gtest.h>

namespace saccade::client {
namespace {

const std::string kPose = " 0 0 0 0 0 0 1\n", kCommaPose = ",0,0,0,0,0,0,1\n";

TEST(TrajectoryLength, APathThatFillsItsStreamIsRight) {
  EXPECT_EQ(trajectoryWarning("# t x y z\n5" + kPose + "7" + kPose, 2), "");
  EXPECT_EQ(trajectoryWarning("timestamp,tx\n0" + kCommaPose + "2000000000" + kCommaPose, 2), "");
  EXPECT_EQ(trajectoryWarning("0" + kPose + "1" + kPose, 0), "");
}

TEST(TrajectoryLength, AShorterOneIsTold) {
  EXPECT_EQ(trajectoryWarning("5" + kPose + "6.5" + kPose, 2),
            "the trajectory lasts 1.5 s (2 poses), the stream 2 s: then the camera stands still");
}

TEST(TrajectoryLength, OnePoseIsTold) {
  EXPECT_EQ(trajectoryWarning("0" + kPose, 2), "the trajectory has one pose: the camera does not move");
  EXPECT_EQ(trajectoryWarning("0" + kPose, 0), "the trajectory has one pose: the camera does not move");
}

TEST(TrajectoryLength, TheWrongUnitIsTold) {
  EXPECT_EQ(
      trajectoryWarning("timestamp,tx\n0" + kCommaPose + "1" + kCommaPose, 0.02),
      "the trajectory lasts 1 ns (2 poses), the stream 0.02 s: then the camera stands still; times of lines "
      "with commas are nanoseconds");
  EXPECT_EQ(trajectoryWarning("0" + kPose + "2000000000" + kPose, 2),
            "the trajectory lasts 2e+09 s (2 poses); times of lines with blanks are seconds");
}

}  // namespace
}  // namespace saccade::client
