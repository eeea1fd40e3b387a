#include "scene/camera/trajectory.h"

#include "base/text_cut.h"
#include "scene/scratch.h"

namespace saccade {
namespace {

using namespace std::chrono_literals;

std::string errorIn(const std::string& csv) {
  return errorOf([&] { parseTrajectory(csv, "path.csv"); });
}

TEST(Trajectory, HoldsItsEndsAndHitsItsKeys) {
  const Pose a{{1, 0, 0}, axisAngle({0, 0.1, 0})}, b{{2, 0, 0}, axisAngle({0, 0.2, 0})};
  const Trajectory path({{10ns, a}, {30ns, b}});
  EXPECT_EQ(path.at(0ns), a);
  EXPECT_EQ(path.at(10ns), a);
  EXPECT_EQ(path.at(20ns), interpolate(a, b, 0.5));
  EXPECT_EQ(path.at(30ns), b);
  EXPECT_EQ(path.at(1h), b);
}

TEST(Trajectory, StandsStillBitForBitBetweenEqualKeys) {
  const Pose a{{0.1, 0.2, 0.3}, normalize(Quaternion{0.3, 0.2, 0.9, 0.1})};
  const Trajectory path({{0ns, a}, {70ns, a}});
  for (int t = 0; t < 70; ++t) EXPECT_EQ(path.at(TimeNs{t}), a);
}

TEST(Trajectory, PeriodicRepeatsForEver) {
  const Pose a{{0, 0, 0}, {}}, b{{1, 0, 0}, {}};
  const Trajectory path = Trajectory::periodic({{0s, a}, {1s, b}, {2s, a}});
  for (const TimeNs t : {TimeNs{500ms}, TimeNs{1s}, TimeNs{1700ms}}) {
    EXPECT_EQ(path.at(t + 2s), path.at(t));
    EXPECT_EQ(path.at(t + 2000000s), path.at(t));
    EXPECT_EQ(path.at(t - 2s), path.at(t));
  }
  EXPECT_EQ(path.at(2s), a);
}

TEST(Trajectory, ACameraGoesWithTheBodyThatItIsFixedTo) {
  const Pose a{{1, 0, 0}, axisAngle({0, 0.1, 0})}, b{{2, 0, 0}, axisAngle({0, 0.9, 0})};
  const Pose mount{{0.1, 0.2, 0.3}, axisAngle({0.3, 0, 0})};
  const Trajectory body({{0ns, a}, {20ns, b}});
  const Trajectory camera = body.mounted(mount);
  EXPECT_EQ(camera.bodyAt(5ns), body.at(5ns));
  EXPECT_EQ(camera.at(5ns), body.at(5ns) * mount);
  EXPECT_EQ(camera.mounted({}).at(5ns), body.at(5ns));
  EXPECT_EQ(camera.at(20ns), b * mount);
}

TEST(ParseTrajectory, ReadsTumInSeconds) {
  const Trajectory path = parseTrajectory(
      "# timestamp tx ty tz qx qy qz qw\n\n1000.5 1 2 3 0 0 0 2\r\n1000.75 4 5 6  0 0 1 0\n", "path.csv");
  EXPECT_EQ(path.at(0ns), (Pose{{1, 2, 3}, {0, 0, 0, 1}}));
  EXPECT_EQ(path.at(250ms), (Pose{{4, 5, 6}, {0, 0, 1, 0}}));
  EXPECT_NE(path.at(249ms), path.at(250ms));
}

TEST(ParseTrajectory, ReadsEsimInNanoseconds) {
  const Trajectory path = parseTrajectory(
      "t,x,y,z,qx,qy,qz,qw\n1700000000000000001,1,2,3,0,0,0,1\n1700000000000000003, 4,5,6,0,0,0,1", "p");
  EXPECT_EQ(path.at(0ns).position, (Vec3d{1, 2, 3}));
  EXPECT_EQ(path.at(2ns).position, (Vec3d{4, 5, 6}));
  EXPECT_EQ(path.at(1ns).position, (Vec3d{2.5, 3.5, 4.5}));
}

// A double of such a time is wrong by a tenth of a microsecond.
TEST(ParseTrajectory, ReadsUnixTimesToTheNanosecond) {
  const PoseText text = readPoses(
      "1700000000.123456789 0 0 0 0 0 0 1\n1700000000.2 0 0 0 0 0 0 1\n1.7000000012e9 0 0 0 0 0 0 1\n", "p");
  EXPECT_EQ(text.begin, 1'700'000'000'123'456'789ns);
  EXPECT_EQ(text.poses[1].time, 76'543'211ns);
  EXPECT_NEAR(static_cast<double>(text.poses[2].time.count()), 1.076543211e9, 300);
  EXPECT_EQ(readPoses("-0.0000000015 0 0 0 0 0 0 1\n", "p").begin, -2ns);
}

TEST(ParseTrajectory, CitesWholeCharacters) {
  std::string word = "x";
  for (int i = 0; i < 50; ++i) word += "é";
  EXPECT_TRUE(isUtf8(errorIn("0 0 0 0 0 0 0 1\n" + word + " 0 0 0 0 0 0 1\n")));
  EXPECT_TRUE(isUtf8(errorIn("0,0,0,0,0,0,0,1\n" + word + ",0,0,0,0,0,0,1\n")));
}

TEST(ParseTrajectory, ARotationOfEitherSignIsTheSameBits) {
  const Trajectory path = parseTrajectory("0 0 0 0 0.1 0.2 0.3 0.9\n1 0 0 0 -0.1 -0.2 -0.3 -0.9\n", "p");
  EXPECT_EQ(path.at(400ms), path.at(0ms));
}

TEST(ParseTrajectory, NamesTheLineOfEachFault) {
  const std::string first = "0 0 0 0 0 0 0 1\n";
  expectContains(errorIn("# nothing\n"), "path.csv:1: no pose");
  expectContains(errorIn(""), "no pose");
  expectContains(errorIn(first + "1 0 0 0 0 0 1\n"), "path.csv:2: a line of 7 fields; expected 8: t x y z");
  expectContains(errorIn(first + "1 0 0 0 0 0 0 1 5\n"), ":2: a line of 9 fields");
  expectContains(errorIn(first + "1,0,0,0,0,0,0,1\n"), ":2: a line of 1 fields");
  expectContains(errorIn("0,0,0,0,0,0,0,1\n5 0 0 0 0 0 0 1\n"), ":2: a line of 1 fields; expected 8: t_ns,x");
  expectContains(errorIn(first + "# remark\n1 0 x 0 0 0 0 1\n"), ":3: 'x' is not a finite number");
  expectContains(errorIn(first + "1 0 nan 0 0 0 0 1\n"), ":2: 'nan' is not a finite number");
  expectContains(errorIn(first + "1 0 1e999 0 0 0 0 1\n"), ":2: '1e999' is not a finite number");
  expectContains(errorIn(first + "1 0 1e10 0 0 0 0 1\n"), ":2: a position beyond");
  expectContains(errorIn(first + "0 0 0 0 0 0 0 1\n"), ":2: the time is not later");
  expectContains(errorIn(first + "1e300 0 0 0 0 0 0 1\n"), ":2: a time too far");
  expectContains(errorIn("1.5,0,0,0,0,0,0,1\n"), ":1: '1.5' is not a time in whole nanoseconds");
  expectContains(errorIn("5,0,0,,0,0,0,1\n"), ":1: '' is not a finite number");
  expectContains(errorIn(first + "1 0 0 0 0 0 0 0\n"), ":2: a quaternion");
  expectContains(errorIn(first + "1 0 0 0 1e200 0 0 0\n"), ":2: a quaternion");
}

TEST(ParseTrajectory, TakesNoMoreThanAMillionPoses) {
  std::string csv;
  for (int i = 0; i <= 1000000; ++i) csv += std::to_string(i) + ",0,0,0,0,0,0,1\n";
  expectContains(errorIn(csv), ":1000001: more than 1000000 poses");
}

}  // namespace
}  // namespace saccade
