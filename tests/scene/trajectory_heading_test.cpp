// Files of poses whose first line names the columns. Expected poses follow from the names.
#include "scene/camera/trajectory.h"
#include "scene/scratch.h"

namespace saccade {
namespace {

using namespace std::chrono_literals;

std::string errorIn(const std::string& csv) {
  return errorOf([&] { parseTrajectory(csv, "path.csv"); });
}

// Two poses with another number in each part.
const std::string kTum =
    "10.5 1 2 3 0.1 0.2 0.3 0.9\n"
    "10.75 4 5 6 -0.3 0.1 0.2 0.8\n";
const std::string kWFirst =
    "10500000000,1,2,3,0.9,0.1,0.2,0.3\n"
    "10750000000,4,5,6,0.8,-0.3,0.1,0.2\n";

void expectTum(const std::string& csv) {
  const Trajectory expected = parseTrajectory(kTum, "tum"), path = parseTrajectory(csv, "p");
  for (const TimeNs t : {TimeNs{0}, TimeNs{70ms}, TimeNs{249999999ns}, TimeNs{250ms}})
    EXPECT_EQ(path.at(t), expected.at(t)) << csv;
}

TEST(TrajectoryHeading, EurocAndTumViHaveWFirst) {
  expectTum(
      "#timestamp [ns],p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m],q_RS_w [],q_RS_x [],q_RS_y [],q_RS_z []\n" +
      kWFirst);
  expectTum("#timestamp [ns],p_x,p_y,p_z,q_w,q_x,q_y,q_z\r\n" + kWFirst);
  expectTum("t[ns],x,y,z,qw,qx,qy,qz\n" + kWFirst);
  expectTum("\xEF\xBB\xBF# Time, X, Y, Z, QW, QX, QY, QZ\n" + kWFirst);
}

TEST(TrajectoryHeading, EurocsStateHasSpeedsAndBiasesToo) {
  const std::string speeds = ",0.1,0.2,0.3,-1,-2,-3,7,8,nan\n";
  expectTum(
      "#timestamp, p_RS_R_x [m], p_RS_R_y [m], p_RS_R_z [m], q_RS_w [], q_RS_x [], q_RS_y [], q_RS_z [], "
      "v_RS_R_x [m s^-1], v_RS_R_y [m s^-1], v_RS_R_z [m s^-1], b_w_RS_S_x [rad s^-1], b_w_RS_S_y [rad "
      "s^-1], "
      "b_w_RS_S_z [rad s^-1], b_a_RS_S_x [m s^-2], b_a_RS_S_y [m s^-2], b_a_RS_S_z [m s^-2]\n"
      "10500000000,1,2,3,0.9,0.1,0.2,0.3" +
      speeds + "10750000000,4,5,6,0.8,-0.3,0.1,0.2" + speeds);
}

TEST(TrajectoryHeading, EveryColumnMayStandAnywhere) {
  expectTum("qz qy qx qw tz ty tx time\n0.3 0.2 0.1 0.9 3 2 1 10.5\n0.2 0.1 -0.3 0.8 6 5 4 10.75\n");
}

TEST(TrajectoryHeading, ARemarkIsNoHeading) {
  expectTum("# ground truth trajectory\n# timestamp tx ty tz qx qy qz qw\n" + kTum);
  expectTum("# time of day\n# file: 'rosbag of x, y and z'\n# t\n" + kTum);
  expectTum("# columns: t x y z qx qy qz qw\n" + kTum);
  expectTum("# t x y z qx qy qz qw, seconds and metres\n" + kTum);
  expectTum(kTum + "# t x y z qw qx qy qz\n");
}

TEST(TrajectoryHeading, TheUnitOfTimeIsItsOwn) {
  const std::string rest = " [m], y [m], z [m], qx, qy, qz, qw\n";
  const std::string a = ",1,2,3,0.1,0.2,0.3,0.9\n", b = ",4,5,6,-0.3,0.1,0.2,0.8\n";
  expectTum("t [s], x" + rest + "10.5" + a + "10.75" + b);
  expectTum("t [us], x" + rest + "10500000.0" + a + "10750000" + b);
  expectTum("# t_us, x" + rest + "10500000" + a + "10750000" + b);
  expectTum("timestamp_ms, x" + rest + "10500" + a + "10750" + b);
  expectTum(
      "# t [ns] x y z qx qy qz qw\n10500000000 1 2 3 0.1 0.2 0.3 0.9\n10750000000 4 5 6 -0.3 0.1 0.2 0.8\n");
}

// 1520530308199447626 ns is no double.
TEST(TrajectoryHeading, NanosecondsAreExact) {
  const std::string pose = ",0,0,0,0,0,0,1\n", next = ",1,0,0,0,0,0,1\n";
  const auto last = [](const std::string& csv) { return parseTrajectory(csv, "p").lastTime(); };
  EXPECT_EQ(last("1520530308199447626" + pose + "1520530308199447627" + next), 1ns);
  EXPECT_EQ(last("1520530308199447626.0" + pose + "1520530308199447629.000" + next), 3ns);
  EXPECT_EQ(last("0.000000" + pose + "40000000.0" + next), 40ms);
  EXPECT_EQ(last("0" + pose + "4e7" + next), 40ms);
}

TEST(TrajectoryHeading, WhatIsNotUnderstoodIsNamed) {
  const std::string pose = "0,0,0,0,0,0,0,1\n";
  expectContains(errorIn("#timestamp,x,y,z,q0,q1,q2,q3\n" + pose),
                 "path.csv:1: the heading names a column 'q0'; valid are t");
  expectContains(errorIn("\nt x y z qx qy qz qw roll\n" + pose),
                 "path.csv:2: the heading names a column 'roll'");
  expectContains(errorIn("# t x y z qx qy qz qw roll\n0 0 0 0 0 0 0 1 5\n"),
                 ":2: a line of 9 fields; expected 8, as the heading names");
  expectContains(errorIn("one header\n" + pose), "path.csv:1: the heading names a column 'one'");
  expectContains(errorIn("t,x,y,z,qx,qy,qz\n" + pose), ":1: the heading names no column for qw");
  expectContains(errorIn("t,x,y,z,qx,qy,qz,qx\n" + pose), ":1: the heading names qx twice");
  expectContains(errorIn("t,x [ft],y,z,qx,qy,qz,qw\n" + pose),
                 ":1: the heading gives 'x' the unit 'ft'; valid are m");
  expectContains(errorIn("t [h],x,y,z,qx,qy,qz,qw\n" + pose),
                 ":1: the heading gives 't' the unit 'h'; valid are ns, us, ms, s");
  expectContains(errorIn("t,x,y,z,qx,qy,qz,qw [deg]\n" + pose), "the heading gives 'qw' the unit 'deg'");
  expectContains(errorIn("t,x,y,z,qx,qy,qz,qw,vx\n" + pose),
                 ":2: a line of 8 fields; expected 9, as the heading names");
  expectContains(errorIn("t,x,y,z,qx,qy,qz,qw\n# t x y z qw qx qy qz\n" + pose),
                 ":2: a second heading, with other");
  std::string many = "t";
  for (int i = 0; i < 64; ++i) many += ",vx";
  expectContains(errorIn(many + "\n" + pose), "more than 64 columns");
}

}  // namespace
}  // namespace saccade
