// `saccade convert`, `saccade verify` and `saccade replay`.
#include "client/command.h"
#include "client/recording/recording_file.h"
#include "client/recording/sidecar.h"

namespace saccade {
namespace {

namespace fs = std::filesystem;
using namespace test;

TEST_F(CommandAndServer, ARecordingIsVerifiedConvertedAndRenderedAgain) {
  const std::string csv = folder_.at("a.csv"), txt = folder_.at("a.txt"), again = folder_.at("b.csv");
  const Result recorded = run(
      "record cornell-box --trajectory right --size 32x24 --duration 0.03 --threshold 0.1 --threshold 0.2 "
      "--delivery broadcast -o " +
      csv + server_.option());
  if (holds(recorded, "the system's libzmq")) GTEST_SKIP() << recorded.output;
  ASSERT_EQ(recorded.code, 0) << recorded.output;
  const std::string second = folder_.at("a-1.csv");
  const Result verified = run("verify " + second);
  EXPECT_EQ(verified.code, 0) << verified.output;
  EXPECT_TRUE(holds(verified, "events are as recorded")) << verified.output;

  ASSERT_EQ(run("convert " + second + " " + txt).code, 0);
  EXPECT_EQ(textOf(txt).substr(0, 6), "32 24\n");
  EXPECT_EQ(run("verify " + txt).code, 0);
  EXPECT_EQ(client::recordingOf(txt)->request().scene(), "cornell-box");
  ASSERT_EQ(run("convert " + txt + " " + again).code, 0);
  EXPECT_EQ(textOf(again), textOf(second));

  const Result replayed = run("replay " + second + ".json --force -o " + again + server_.option());
  EXPECT_EQ(replayed.code, 0) << replayed.output;
  EXPECT_TRUE(holds(replayed, "the events are those of the recording")) << replayed.output;
  EXPECT_EQ(textOf(again), textOf(second));
}

TEST_F(CommandAndServer, AReplayThatDiffersSaysWhy) {
  const std::string csv = folder_.at("a.csv"), again = folder_.at("b.csv");
  ASSERT_EQ(
      run("record cornell-box --trajectory right --size 32x24 --duration 0.01 -o " + csv + server_.option())
          .code,
      0);
  v1::Recording recording = *client::recordingOf(csv);
  recording.set_digest("another");
  recording.set_instruction_set("sse9");
  client::writeSidecar(client::sidecarOf(csv), recording);
  const Result result = run("replay " + csv + ".json -o " + again + server_.option());
  EXPECT_EQ(result.code, 1);
  EXPECT_TRUE(
      holds(result, "the events are not those of the recording; the instruction set was 'sse9' and is"))
      << result.output;
  recording.set_begin_ns(1000);
  client::writeSidecar(client::sidecarOf(csv), recording);
  const Result joined = run("replay " + csv + ".json --force -o " + again + server_.option());
  EXPECT_EQ(joined.code, 2);
  EXPECT_TRUE(holds(joined, "joined a running stream")) << joined.output;
}

class ConvertCommand : public testing::Test {
 protected:
  std::string fileOf(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.at(name)) << text;
    return folder_.at(name);
  }
  const ScratchFolder folder_;
};

TEST_F(ConvertCommand, AFileOfOtherProgramsNeedsItsSizeOnly) {
  const std::string csv = fileOf("a.csv", "t_us,x,y,p\n1,2,1,1\n7,0,0,0\n"), txt = folder_.at("a.txt");
  const Result without = run("convert " + csv + " " + txt);
  EXPECT_EQ(without.code, 2);
  EXPECT_TRUE(holds(without, "does not tell the size of the image; give WIDTHxHEIGHT")) << without.output;
  const Result small = run("convert --size 2x2 " + csv + " " + txt);
  EXPECT_EQ(small.code, 1);
  EXPECT_TRUE(holds(small, "event 1 is at (2, 1), outside of 2x2 pixels")) << small.output;
  EXPECT_FALSE(fs::exists(txt));
  ASSERT_EQ(run("convert --size 3x2 " + csv + " " + txt).code, 0);
  EXPECT_EQ(textOf(txt), "3 2\n0.000001000 2 1 1\n0.000007000 0 0 0\n");
  EXPECT_EQ(run("verify " + txt).code, 0);
}

TEST_F(ConvertCommand, AChangedFileIsFound) {
  const std::string csv = fileOf("a.csv", "t_us,x,y,p\n1,2,1,1\n7,0,0,0\n"), txt = folder_.at("a.txt");
  ASSERT_EQ(run("convert --size 3x2 " + csv + " " + txt).code, 0);
  fileOf("a.txt", "3 2\n0.000001000 2 1 1\n0.000007000 0 1 0\n");
  const Result changed = run("verify " + txt);
  EXPECT_EQ(changed.code, 1);
  EXPECT_TRUE(holds(changed, "the events are not those that")) << changed.output;
  EXPECT_EQ(run("convert --force " + txt + " " + csv).code, 1);
  EXPECT_EQ(textOf(csv), "t_us,x,y,p\n1,2,1,1\n7,0,0,0\n");
  fileOf("a.txt", "3 2\n0.000001000 2 1 1\n");
  EXPECT_TRUE(holds(run("verify " + txt), "has 1 events, not 2"));
}

TEST_F(ConvertCommand, VerifyAsksForNoOptionThatItHasNot) {
  const std::string csv = fileOf("a.csv", "t_us,x,y,p\n");
  fileOf("a.csv.json", "{}");
  EXPECT_EQ(run("verify " + csv).output,
            "saccade: '" + csv + "' does not tell the size of the image, nor does " + csv + ".json\n");
}

TEST_F(ConvertCommand, AFileThatIsBeingWrittenIsRefusedBeforeAnyWork) {
  const std::string csv = fileOf("a.csv", "t_us,x,y,p\n");
  fileOf("b.json", "{\"request\": {\"sensors\": [{}]}, \"end_ns\": 1000}");
  const std::string record =
      "record cornell-box --trajectory right --control ipc:///nobody --retry-time 0 -o ";
  const std::string replay = "replay " + folder_.at("b.json") + " --control ipc:///nobody -o ";
  for (const std::string name : {"o.csv", "o.npz", "o.raw", "o.aedat4", "o.txt", "o.h5", "o.bag", "o.mcap"}) {
    const std::string out = folder_.at(name), partial = client::partialOf(out);
    const client::OutputFile other(partial);
    const std::string told = "--output: '" + partial + "' is being written by another program";
    for (const std::string& command : {record + out, replay + out, "convert --size 3x2 " + csv + " " + out}) {
      const Result refused = run(command);
      EXPECT_EQ(refused.code, 2) << command;
      EXPECT_TRUE(holds(refused, told)) << command << "\n" << refused.output;
    }
  }
  const client::OutputFile other(client::partialOf(folder_.at("r-1.csv")));
  EXPECT_TRUE(
      holds(run(record + folder_.at("r.csv") + " --further-view 1,0,0"), "r-1.csv.partial' is being"));
}

TEST_F(ConvertCommand, WrongUsageSaysWhatIsKnown) {
  const std::string csv = fileOf("a.csv", "t_us,x,y,p\n");
  EXPECT_TRUE(holds(run("verify " + csv), "there is no " + csv + ".json"));
  EXPECT_TRUE(holds(run("convert --size 3x2 " + csv + " " + folder_.at("a.xyz")), ".csv csv ("));
  EXPECT_TRUE(holds(run("convert --size 3x2 --format abc " + csv + " " + folder_.at("a.txt")),
                    "--format: 'abc' is not known"));
  EXPECT_TRUE(holds(run("convert --size 3x2 " + folder_.at("a.png") + " " + folder_.at("a.txt")),
                    "has no extension that can be read; known are "));
}

}  // namespace
}  // namespace saccade
