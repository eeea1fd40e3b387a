// `saccade-eval tasks` as a user runs it, on very small pictures.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "client/scratch_folder.h"

namespace saccade::client {
namespace {

struct TasksCommand : testing::Test {
  ScratchFolder folder;

  // The exit code. The output goes to `log`.
  int tasks(const std::string& arguments) {
    const std::string command = std::string(SACCADE_EVAL) + " tasks " + arguments +
                                " --reference 64 --cache " + folder.at("cache") + " -o " + folder.at("out") +
                                " > " + folder.at("log") + " 2>&1";
    return WEXITSTATUS(std::system(command.c_str()));
  }
  std::string text(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(folder.at(name)).rdbuf();
    return text.str();
  }
  long rowsWith(const std::string& part) const {
    std::istringstream table(text("out/tasks.csv"));
    std::string line;
    long rows = 0;
    while (std::getline(table, line)) rows += line.find(part) != line.npos;
    return rows;
  }
  void expectSaid(const std::string& part) const {
    EXPECT_NE(text("log").find(part), std::string::npos) << text("log");
  }
};

// A camera that goes to the right gives no task of rotation, and nothing of the scene moves.
TEST_F(TasksCommand, WritesARowForEachTaskSourceAndNoise) {
  ASSERT_EQ(tasks("cornell-box --size 24x16 --frames 1:16 --motion truck:1px --methods svgf,pt --spp 2,4 "
                  "--repeats 1 --threshold 0.1 --noise none,davis346"),
            0)
      << text("log");
  EXPECT_EQ(rowsWith(",reference,64,"), 2 * 6);
  EXPECT_EQ(rowsWith(",none,"), 6 + 2 * 2 * 6);
  EXPECT_EQ(rowsWith(",davis346,"), 6 + 2 * 2 * 6);
  EXPECT_EQ(rowsWith(",rotation,") + rowsWith(",moving_objects,"), 0);
  EXPECT_NE(text("out/cornell-box.svg").find("complementary"), std::string::npos);
  expectSaid("cornell-box, noise of davis346");
}

TEST_F(TasksCommand, ScoresWhatMovesAndWhatTurns) {
  ASSERT_EQ(tasks("cornell-bunny --object bunny=slide:0.05/frame --size 32x24 --frames 1:8 --motion pan:1px "
                  "--methods event_svgf --spp 2 --repeats 1 --noise none --tasks rotation,moving_objects"),
            0)
      << text("log");
  EXPECT_EQ(rowsWith(",rotation,event_svgf,2,"), 1);
  EXPECT_EQ(rowsWith(",moving_objects,event_svgf,2,"), 1);
  EXPECT_EQ(rowsWith("cornell-bunny,"), 4);
}

// This camera looks along -z of the world. In the world's axes its velocity would be wrong by 2 of itself.
TEST_F(TasksCommand, ScoresTheVelocityInTheAxesOfTheCamera) {
  ASSERT_EQ(
      tasks("cornell-box --size 48x36 --frames 1:16 --motion truck:1px --methods svgf --spp 2 --repeats 1 "
            "--noise none --tasks ego_velocity"),
      0)
      << text("log");
  const std::string table = text("out/tasks.csv"), source = ",ego_velocity,reference,";
  double cpu_ms = 0, events = 0, error = 0;
  const auto place = table.find(source);
  ASSERT_NE(place, table.npos);
  ASSERT_EQ(std::sscanf(table.c_str() + place + source.size(), "%*d,%lf,%lf,%lf", &cpu_ms, &events, &error),
            3);
  EXPECT_LT(error, 0.6);
}

TEST_F(TasksCommand, RefusesWrongFlags) {
  EXPECT_EQ(tasks("cornell-box --tasks driving"), 2);
  expectSaid(
      "there is no \"driving\"; there are: normal_flow, patch_flow, rotation, ego_velocity, moving_objects, "
      "high_pass, complementary, corner_tracks");
  EXPECT_EQ(tasks("cornell-box --noise eye"), 2);
  expectSaid("there is no \"eye\"; there are: none, davis346, ");
  EXPECT_EQ(tasks("cornell-box --methods event_svgf --spp 3"), 2);
  EXPECT_EQ(tasks(""), 2);
  EXPECT_EQ(tasks("cornell-box --size 8x8 --frames 1:2 --motion truck:1px --tasks rotation"), 1);
  expectSaid("no task applies; rotation needs a camera that only turns, ego_velocity one that goes");
}

}  // namespace
}  // namespace saccade::client
