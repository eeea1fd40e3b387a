// Options of a request that move the camera and objects.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "request_line.h"
#include "scratch_folder.h"

namespace saccade::client {
namespace {

TEST(MotionOptions, AFileOfPosesIsSentAsText) {
  const ScratchFolder folder;
  const std::string path = folder.at("path.csv");
  std::ofstream(path) << "0 0 0 0 0 0 0 1\n";
  const auto options = parse("cornell-box --trajectory " + path);
  EXPECT_EQ(makeOpenStream(options).trajectory().csv(), "0 0 0 0 0 0 0 1\n");
  std::ofstream(path, std::ios::trunc).close();
  EXPECT_THROW(makeOpenStream(options), std::invalid_argument);  // empty
  for (const std::string bytes : {"\xFF", "\x80", "\xC3", "\xC3x", "\xC0\x80"}) {
    std::ofstream(path, std::ios::trunc) << bytes;
    EXPECT_THROW(makeOpenStream(options), std::invalid_argument);  // not text
  }
  std::ofstream(path, std::ios::trunc) << "# \xC3\xBC \xE2\x82\xAC \xF0\x9F\x98\x80\n";
  EXPECT_EQ(makeOpenStream(options).trajectory().csv().size(), 14u);
  std::filesystem::remove(path);
  EXPECT_THROW(makeOpenStream(options), std::invalid_argument);
}

v1::OpenStream openMotion(const std::string& line) {
  return makeOpenStream(parse("cornell-box --motion " + line));
}

TEST(MotionOptions, AMotionHasASpeedPerSecondOrInPixels) {
  const v1::Motion pan = openMotion("pan:-15 --turn 0").trajectory().motion();
  EXPECT_EQ(pan.kind(), v1::MOTION_KIND_PAN);
  EXPECT_EQ(pan.speed(), -15);
  EXPECT_TRUE(pan.has_turn_s() && pan.turn_s() == 0);
  const v1::Motion shake = openMotion("shake:0.7px --motion-seed 9").trajectory().motion();
  EXPECT_EQ(shake.kind(), v1::MOTION_KIND_SHAKE);
  EXPECT_EQ(shake.px_per_frame(), 0.7);
  EXPECT_EQ(shake.seed(), 9u);
  EXPECT_FALSE(shake.has_turn_s());
}

TEST(MotionOptions, AFaultyMotionIsNamed) {
  const auto fault = [](const std::string& line) {
    try {
      openMotion(line);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(fault("fly:1"),
            "--trajectory: 'fly' is none of dolly, truck, pedestal, pan, tilt, roll, orbit, shake, random, "
            "roam");
  EXPECT_NE(fault("unspecified:1").find("is none of"), std::string::npos);
  for (const std::string text : {"pan:", "pan:px", "pan:1p", "pan:1:2", ":1"}) {
    EXPECT_EQ(fault(text).find("--trajectory: '"), 0u) << text;
  }
  for (const std::string start : {"1,2", "a,b,c", "1,2,3,0"})
    EXPECT_NE(fault("pan:1 --start " + start).find("is not X,Y,Z or X,Y,Z,QX,QY,QZ,QW"), std::string::npos)
        << start;
}

TEST(MotionOptions, ObjectsMoveByAMotionOrByAFile) {
  const ScratchFolder folder;
  const std::string path = folder.at("poses.txt");
  std::ofstream(path) << "0 1 2 3 0 0 0 1\n";
  const auto open = openStream("--object bunny=spin:-90 --object lamp=" + path);
  ASSERT_EQ(open.objects_size(), 2);
  EXPECT_EQ(open.objects(0).name(), "bunny");
  EXPECT_EQ(open.objects(0).path().motion().kind(), v1::OBJECT_MOTION_KIND_SPIN);
  EXPECT_EQ(open.objects(0).path().motion().speed(), -90);
  EXPECT_EQ(open.objects(1).name(), "lamp");
  EXPECT_EQ(open.objects(1).path().csv(), "0 1 2 3 0 0 0 1\n");
  const auto others = openStream("--object bunny=still --object lamp=own");
  EXPECT_TRUE(others.objects(0).path().has_still());
  EXPECT_TRUE(others.objects(1).path().has_own());
}

TEST(MotionOptions, AFaultyObjectIsNamed) {
  for (const char* wrong : {"bunny", "=spin:90", "bunny="})
    EXPECT_EQ(faultOf(std::string("--object ") + wrong),
              std::string("--object: '") + wrong + "' is not NAME=PATH, such as bunny=spin:90");
  for (const char* wrong : {"spin", "spin:fast", "spin:"})
    EXPECT_EQ(faultOf(std::string("--object bunny=") + wrong),
              std::string("--object: '") + wrong +
                  "' is neither a .csv or .txt file, nor KIND:SPEED such as spin:90, nor still or own");
  EXPECT_EQ(faultOf("--object bunny=fly:1"), "--object: 'fly' is none of spin, orbit, slide, swing");
  EXPECT_EQ(faultOf("--object bunny=none.txt"), "--object: 'none.txt' cannot be read");
}

TEST(MotionOptions, OnlyRoamHasAClearance) {
  EXPECT_FALSE(openMotion("roam:1px").trajectory().motion().has_clearance());
  const v1::Motion roam = openMotion("roam:1px --clearance 0.25").trajectory().motion();
  EXPECT_EQ(roam.kind(), v1::MOTION_KIND_ROAM);
  EXPECT_EQ(roam.clearance(), 0.25);
  EXPECT_THROW(openMotion("random:1px --clearance 0.25"), std::invalid_argument);
}

TEST(MotionOptions, AMotionHasAStartWhereOneIsGiven) {
  EXPECT_FALSE(openMotion("pan:1").trajectory().motion().has_start());
  const v1::RigidTransform place = openMotion("pan:1 --start 1,-2,3e-1").trajectory().motion().start();
  EXPECT_EQ(place.position().y(), -2);
  EXPECT_EQ(place.position().z(), 0.3);
  EXPECT_FALSE(place.has_rotation());
  const v1::RigidTransform pose =
      openMotion("random:2px --start 0,0,0,0,1,0,2").trajectory().motion().start();
  EXPECT_EQ(pose.rotation().y(), 1);
  EXPECT_EQ(pose.rotation().w(), 2);
}

TEST(MotionOptions, TrajectoryAndMotionTakeTheSameWords) {
  for (const std::string option : {"--trajectory ", "--motion "}) {
    const auto open = [&](const std::string& word) {
      return makeOpenStream(parse("cornell-box " + option + word)).trajectory();
    };
    EXPECT_EQ(open("right").name(), "right");
    EXPECT_EQ(open("orbit").name(), "orbit");
    EXPECT_EQ(open("orbit:10").motion().kind(), v1::MOTION_KIND_ORBIT);
    EXPECT_EQ(open("orbit:10").motion().speed(), 10);
  }
}

TEST(MotionOptions, ThereIsOneTrajectoryOrTheServerTellsWhatThereIs) {
  EXPECT_NE(faultOf("--motion pan:1").find("--trajectory"), std::string::npos);  // the second one
  EXPECT_NE(faultOf("--turn 1").find("--motion"), std::string::npos);
  EXPECT_NE(faultOf("--motion-seed 1").find("--motion"), std::string::npos);
  EXPECT_EQ(faultOf("--clearance 1").find("--clearance goes with --motion roam:SPEED"), 0u);
  EXPECT_NE(faultOf("--start 1,2,3").find("--start: '1,2,3' goes with --motion KIND:SPEED"),
            std::string::npos);
  EXPECT_EQ(makeOpenStream(parse("cornell-box")).trajectory().path_case(), v1::Trajectory::PATH_NOT_SET);
}

}  // namespace
}  // namespace saccade::client
