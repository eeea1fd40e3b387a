// KITTI's and COLMAP's files of poses, as `saccade record` sends them. The expected poses are rotations by
// quarter turns, whose matrices and quaternions are known.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "client/options/request_options.h"
#include "scratch_folder.h"

namespace saccade::client {
namespace {

class PoseFile : public testing::Test {
 protected:
  std::string write(const std::string& text) const {
    std::ofstream(path_, std::ios::binary) << text;
    return path_;
  }
  v1::Trajectory read(const std::string& format, const std::string& text, double rate_hz) const {
    RequestOptions options;
    options.trajectory = write(text);
    options.pose_format = format;
    options.pose_rate_hz = rate_hz;
    return makeTrajectory(options);
  }
  std::string faultOf(const std::string& format, const std::string& text) const {
    try {
      read(format, text, 10);
    } catch (const std::invalid_argument& fault) {
      return fault.what();
    }
    return "no fault";
  }
  const ScratchFolder folder_;
  const std::string path_ = folder_.at("poses");
};

using Row = std::array<double, 8>;

std::vector<Row> rowsOf(const v1::Trajectory& trajectory) {
  std::istringstream lines(trajectory.csv());
  std::vector<Row> rows;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream cells(line);
    std::string cell;
    for (double& value : rows.emplace_back()) {
      EXPECT_TRUE(std::getline(cells, cell, ',')) << line;
      value = std::stod(cell);
    }
    EXPECT_FALSE(std::getline(cells, cell, ',')) << line;
  }
  return rows;
}

void expectRow(const Row& row, const Row& expected) {
  const double sign =
      row[7] * expected[7] + row[4] * expected[4] + row[5] * expected[5] + row[6] * expected[6] < 0 ? -1 : 1;
  for (std::size_t i = 0; i < row.size(); ++i)
    EXPECT_NEAR((i < 4 ? 1 : sign) * row[i], expected[i], 1e-6) << i;
}

void expectContains(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

const double kHalf = std::sqrt(0.5);

TEST_F(PoseFile, KittisRowsArePosesOfTheCamera) {
  const auto rows = rowsOf(read("kitti",
                                "1 0 0 5 0 1 0 6 0 0 1 7\n"
                                "0 -1 0 8 1 0 0 9 0 0 1 10\n"            // a quarter turn about z
                                "1.000e+00 0 0 1 0 -1 0 2 0 0 -1 3\r\n"  // half a turn about x
                                "-1 0 0 0 0 1 0 0 0 0 -1 0\n"            // about y
                                "-1 0 0 0 0 -1 0 0 0 0 1 0\n",           // about z
                                10));
  ASSERT_EQ(rows.size(), 5u);
  expectRow(rows[0], {0, 5, 6, 7, 0, 0, 0, 1});
  expectRow(rows[1], {1e8, 8, 9, 10, 0, 0, kHalf, kHalf});
  expectRow(rows[2], {2e8, 1, 2, 3, 1, 0, 0, 0});
  expectRow(rows[3], {3e8, 0, 0, 0, 0, 1, 0, 0});
  expectRow(rows[4], {4e8, 0, 0, 0, 0, 0, 1, 0});
}

// The pose of the second picture takes a point p of the world to R p + t, with a quarter turn R about x. So
// the camera is at -R^T t, and R^T takes (1, 2, 3) to (1, 3, -2).
TEST_F(PoseFile, ColmapsPosesAreInvertedAndOrderedByTheNumbersOfThePictures) {
  const std::string half = std::to_string(kHalf);
  const auto rows = rowsOf(read("colmap",
                                "# Image list with two lines of data per image:\n"
                                "#   IMAGE_ID, QW, QX, QY, QZ, TX, TY, TZ, CAMERA_ID, NAME\n"
                                "3 " +
                                    half + " " + half +
                                    " 0 0 1 2 3 1 cam0/frame10.png\n"
                                    "100.5 200.25 -1 10 20 77\n"
                                    "1 1 0 0 0 0 0 -4 1 cam0/frame9.png\n"
                                    "\n"
                                    "2 1 0 0 0 0 0 0 1 cam0/frame12.png",
                                4));
  ASSERT_EQ(rows.size(), 3u);
  expectRow(rows[0], {0, 0, 0, 4, 0, 0, 0, 1});
  expectRow(rows[1], {2.5e8, -1, -3, 2, -kHalf, 0, 0, kHalf});
  expectRow(rows[2], {7.5e8, 0, 0, 0, 0, 0, 0, 1});
}

TEST_F(PoseFile, FaultsNameTheLine) {
  const std::string good = "1 1 0 0 0 0 0 0 1 a9.png\n\n";
  expectContains(faultOf("kitti", "\n1 0 0 5 0 1 0 6 0 0 1\n"),
                 "poses:2: a line of 11 numbers; KITTI has 12");
  expectContains(faultOf("kitti", "1 0 0 5 0 1 0 6 0 0 x 7\n"), "poses:1: 'x' is not a finite number");
  expectContains(faultOf("kitti", "1 0 0 5 0 1 0 6 0 0 2 7\n"),
                 "poses:1: the first three columns are no rotation");
  expectContains(faultOf("kitti", "1 0 0 5 0 1 0 6 0 0 -1 7\n"), "are no rotation");  // a mirror
  expectContains(faultOf("colmap", good + "2 1 0 0 0 0 0 0 1\n"), "poses:3: not a picture");
  expectContains(faultOf("colmap", good + "2 2 0 0 0 0 0 0 1 a10.png\n"), "poses:3: a quaternion");
  expectContains(faultOf("colmap", good + "2 1 0 0 0 0 0 0 1 a.png\n"),
                 "poses:3: the name 'a.png' has no number");
  expectContains(faultOf("colmap", good + "2 1 0 0 0 0 0 0 1 b9.png\n"),
                 "'a9.png' and 'b9.png' have one number");
  expectContains(faultOf("colmap", "1 1 0 0 0 0 0 0 1 a9.png\n2 1 0 0 0 0 0 0 1 a10.png\n"),
                 "poses:2: not the points");
  expectContains(faultOf("colmap", good + "2 1 0 0 0 0 0 0 1 a18446744073709551615.png\n"),
                 "more than 9e9 s");
  expectContains(faultOf("kitti", std::string(20 << 20, ' ')), "poses:1: a line of more than 16 MiB");
}

TEST_F(PoseFile, OneOptionWantsTheOther) {
  RequestOptions options;
  options.trajectory = write("1 0 0 5 0 1 0 6 0 0 1 7\n");
  options.pose_format = "kitti";
  EXPECT_THROW(makeTrajectory(options), std::invalid_argument);
  options.pose_format = "";
  options.pose_rate_hz = 10;
  EXPECT_THROW(makeTrajectory(options), std::invalid_argument);
}

TEST_F(PoseFile, ALongFileIsNotTakenIntoMemory) {
  RequestOptions options;
  options.trajectory = write("");
  std::filesystem::resize_file(path_, std::uintmax_t{1} << 40);
  try {
    makeTrajectory(options);
    FAIL();
  } catch (const std::invalid_argument& fault) {
    expectContains(fault.what(), "is longer than 8388608 bytes");
  }
}

}  // namespace
}  // namespace saccade::client
