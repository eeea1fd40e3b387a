// `saccade record` along a file of poses: its length, its times, and the poses as text.
#include "command.h"

namespace saccade::test {
namespace {

class AlongAFile : public CommandAndServer {
 protected:
  AlongAFile() {
    std::ofstream(folder_.at("path.txt")) << "1700000000.5 0 0 0 0 0 0 1\n1700000000.52 0.1 0 0 0 0 0 1\n";
  }
  Result record(const std::string& options) {
    return run("record cornell-box --trajectory " + folder_.at("path.txt") +
               " --size 16x12 --rate 100 --truth pose --write-poses --force " + options + server_.option());
  }
};

std::string firstLine(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

TEST_F(AlongAFile, TheRecordingEndsWithThePath) {
  const Result result = record("-o " + folder_.at("a.csv"));
  ASSERT_EQ(result.code, 0) << result.output;
  EXPECT_NE(textOf(folder_.at("a.csv.json")).find("\"end_ns\": \"20000000\""), std::string::npos);
  EXPECT_FALSE(holds(result, "warning: the trajectory")) << result.output;
  const Result cut = record("--duration 0.01 -o " + folder_.at("a.csv"));
  EXPECT_TRUE(holds(cut, "the trajectory lasts 0.02 s, the stream 0.01 s: the rest of the path is left out"))
      << cut.output;
}

// t x y z qx qy qz qw, as evo reads it.
TEST_F(AlongAFile, ThePosesAreTextToo) {
  ASSERT_EQ(record("-o " + folder_.at("a.npz")).code, 0);
  EXPECT_EQ(textOf(folder_.at("a.npz.tum.txt")).find("0.000000 0 0 0 0 0 0 1\n0.010000 0.05 0 0 0 0 0 1\n"),
            0u)
      << textOf(folder_.at("a.npz.tum.txt"));
}

TEST_F(AlongAFile, TheTimesOfTheFileCanBeKept) {
  ASSERT_EQ(record("-o " + folder_.at("a.csv")).code, 0);
  const Result kept = record("--keep-times -o " + folder_.at("b.csv"));
  ASSERT_EQ(kept.code, 0) << kept.output;
  EXPECT_EQ(firstLine(textOf(folder_.at("b.csv.tum.txt"))), "1700000000.500000 0 0 0 0 0 0 1");
  EXPECT_NE(textOf(folder_.at("b.csv.json")).find("\"begin_ns\": \"1700000000500000000\""),
            std::string::npos);
  const std::string from_zero = textOf(folder_.at("a.csv")), from_file = textOf(folder_.at("b.csv"));
  EXPECT_EQ(std::count(from_zero.begin(), from_zero.end(), '\n'),
            std::count(from_file.begin(), from_file.end(), '\n'));
  const auto first = [](const std::string& text) { return std::stoll(text.substr(text.find('\n') + 1)); };
  EXPECT_EQ(first(from_file) - first(from_zero), 1'700'000'000'500'000);
  EXPECT_EQ(run("verify " + folder_.at("b.csv")).code, 0);
  const Result again =
      run("replay " + folder_.at("b.csv.json") + " -o " + folder_.at("c.csv") + server_.option());
  EXPECT_EQ(again.code, 0) << again.output;
  EXPECT_EQ(textOf(folder_.at("c.csv")), from_file);
}

TEST_F(AlongAFile, AnObjectMovesAlongOneTooAndAgainInAReplay) {
  std::ofstream(folder_.at("block.csv")) << "0,3,1,3,0,0,0,1\n20000000,2,1,3,0,0,0,1\n";
  const std::string command =
      "record cornell-box --motion still --size 16x12 --rate 100 --duration 0.05 -o " + folder_.at("a.csv") +
      server_.option();
  const Result result = run(command + " --object tall_block=" + folder_.at("block.csv"));
  ASSERT_EQ(result.code, 0) << result.output;
  EXPECT_NE(textOf(folder_.at("a.csv.json")).find("\"name\": \"tall_block\""), std::string::npos);
  const std::string events = textOf(folder_.at("a.csv"));
  EXPECT_GT(std::count(events.begin(), events.end(), '\n'), 10);
  const Result again =
      run("replay " + folder_.at("a.csv.json") + " -o " + folder_.at("b.csv") + server_.option());
  EXPECT_EQ(again.code, 0) << again.output;
  EXPECT_EQ(textOf(folder_.at("b.csv")), events);
  const Result wrong = run(command + " --force --object teapot=spin:9");
  EXPECT_NE(wrong.code, 0);
  EXPECT_TRUE(holds(wrong, "--object: the scene has no object 'teapot'; it has: back_wall")) << wrong.output;
}

// The scene moves the ball and the turntable; a copy of their poses moves them in the same way.
TEST_F(AlongAFile, PosesOfObjectsAreTextThatMovesThemAgain) {
  const std::string command =
      "record cornell-turntable --motion still --size 16x12 --rate 100 --duration 0.05 " + server_.option() +
      " --truth object_poses --write-poses -o ";
  ASSERT_EQ(run(command + folder_.at("a.csv")).code, 0);
  const auto poses = [&](const std::string& name) { return folder_.at("a.csv.object-" + name + ".tum.txt"); };
  const std::string turntable = textOf(poses("turntable"));
  EXPECT_EQ(std::count(turntable.begin(), turntable.end(), '\n'), 6);
  // 60 degrees per second about the axis that is up, y.
  EXPECT_NE(turntable.find("0.050000 "), std::string::npos);
  EXPECT_NE(turntable.find(" 0 0.02617694"), std::string::npos) << turntable;
  const Result again = run(command + folder_.at("b.csv") + " --object ball=" + poses("ball") +
                           " --object turntable=" + poses("turntable"));
  ASSERT_EQ(again.code, 0) << again.output;
  EXPECT_EQ(textOf(folder_.at("b.csv.object-ball.tum.txt")), textOf(poses("ball")));
  EXPECT_EQ(textOf(folder_.at("b.csv")), textOf(folder_.at("a.csv")));
}

TEST_F(AlongAFile, PosesOfObjectsReplaceNothingUnasked) {
  std::ofstream(folder_.at("a.csv.object-ball.tum.txt")) << "mine";
  const std::string command =
      "record cornell-turntable --motion still --size 16x12 --rate 100 --duration 0.01 " + server_.option() +
      " --truth object_poses --write-poses -o " + folder_.at("a.csv");
  const Result result = run(command);
  EXPECT_EQ(result.code, 2) << result.output;
  EXPECT_TRUE(holds(result, "a.csv.object-ball.tum.txt' exists; --force replaces it")) << result.output;
  EXPECT_EQ(textOf(folder_.at("a.csv.object-ball.tum.txt")), "mine");
  EXPECT_EQ(run(command + " --force").code, 0);
  EXPECT_NE(textOf(folder_.at("a.csv.object-ball.tum.txt")), "mine");
}

TEST_F(AlongAFile, AFormatWhoseTimesWrapKeepsNone) {
  const Result result = record("--keep-times -o " + folder_.at("a.raw"));
  EXPECT_EQ(result.code, 2);
  EXPECT_TRUE(holds(result, "--keep-times: evt3 holds only times that begin near 0")) << result.output;
}

}  // namespace
}  // namespace saccade::test
