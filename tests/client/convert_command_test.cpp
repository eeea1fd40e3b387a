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
  const std::string csv = fileOf("a.csv", "t,x,y,p\n1,2,1,1\n7,0,0,0\n"), txt = folder_.at("a.txt");
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
  const std::string csv = fileOf("a.csv", "t,x,y,p\n1,2,1,1\n7,0,0,0\n"), txt = folder_.at("a.txt");
  ASSERT_EQ(run("convert --size 3x2 " + csv + " " + txt).code, 0);
  fileOf("a.txt", "3 2\n0.000001000 2 1 1\n0.000007000 0 1 0\n");
  const Result changed = run("verify " + txt);
  EXPECT_EQ(changed.code, 1);
  EXPECT_TRUE(holds(changed, "the events are not those that")) << changed.output;
  EXPECT_EQ(run("convert --force " + txt + " " + csv).code, 1);
  EXPECT_EQ(textOf(csv), "t,x,y,p\n1,2,1,1\n7,0,0,0\n");
  fileOf("a.txt", "3 2\n0.000001000 2 1 1\n");
  EXPECT_TRUE(holds(run("verify " + txt), "has 1 events, not 2"));
}

TEST_F(ConvertCommand, VerifyAsksForNoOptionThatItHasNot) {
  const std::string csv = fileOf("a.csv", "t,x,y,p\n");
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

TEST_F(ConvertCommand, WhatWasAssumedIsSaid) {
  const std::string txt = fileOf("a.txt", "0.000001 2 1 1\n0.0000072 0 0 -1\n"), csv = folder_.at("a.csv");
  const Result converted = run("convert --size 3x2 " + txt + " " + csv);
  EXPECT_EQ(converted.code, 0);
  EXPECT_TRUE(
      holds(converted, "saccade: " + txt +
                           ": read t as seconds (it has a decimal point), columns t x y p, size 3x2 from "
                           "--size\n"))
      << converted.output;
  EXPECT_EQ(textOf(csv), "t,x,y,p\n1,2,1,1\n7,0,0,0\n");
  const Result own = run("convert --force " + csv + " " + txt);  // with the description of that file
  EXPECT_EQ(own.code, 0);
  EXPECT_FALSE(holds(own, "read t as")) << own.output;
}

TEST_F(ConvertCommand, TheUserSaysWhatTheFileDoesNot) {
  const std::string csv = fileOf("a.csv", "0,0,0,1\n2,0,0,1\n"), out = folder_.at("b.csv");
  EXPECT_TRUE(holds(run("convert --size 3x2 " + csv + " " + out), "--columns t,x,y,p or --columns x,y,p,t"));
  ASSERT_EQ(run("convert --size 3x2 --columns x,y,p,t --unit ms " + csv + " " + out).code, 0);
  EXPECT_EQ(textOf(out), "t,x,y,p\n1000,0,0,0\n1000,2,0,0\n");
  const Result unit = run("convert --force --size 3x2 --unit min " + csv + " " + out);
  EXPECT_EQ(unit.code, 2);
  EXPECT_TRUE(holds(unit, "--unit: 'min' is not known; known are s, ms, us, ns")) << unit.output;
}

TEST_F(ConvertCommand, LateEventsAndThoseOutsideAreMendedOnlyWhenAsked) {
  const std::string csv = fileOf("a.csv", "t,x,y,p\n100,1,1,1\n110,2,1,0\n108,3,1,1\n120,4,1,0\n");
  const std::string out = folder_.at("b.csv"), convert = "convert --force --size 4x2 ";
  const Result late = run(convert + csv + " " + out);
  EXPECT_EQ(late.code, 1);
  EXPECT_TRUE(holds(late, "event 3 is 2 us earlier than the one before; --sort WINDOW_US")) << late.output;
  const Result outside = run(convert + "--sort 2 " + csv + " " + out);
  EXPECT_EQ(outside.code, 1);
  EXPECT_TRUE(holds(outside, "event 4 is at (4, 1), outside of 4x2 pixels; --crop leaves such events out"))
      << outside.output;
  const Result mended = run(convert + "--sort 2 --crop " + csv + " " + out);
  EXPECT_EQ(mended.code, 0);
  EXPECT_TRUE(holds(mended,
                    "3 events\n1 events outside of the image were left out (--crop)\n"
                    "1 events were late, by at most 2 us, and are in order now (--sort)\n"))
      << mended.output;
  EXPECT_EQ(textOf(out), "t,x,y,p\n100,1,1,1\n108,3,1,1\n110,2,1,0\n");
  EXPECT_EQ(run("verify " + out).code, 0);
  EXPECT_TRUE(holds(run(convert + "--sort 1 " + csv + " " + out), "beyond the window of --sort 1"));
}

TEST_F(ConvertCommand, WrongUsageSaysWhatIsKnown) {
  const std::string csv = fileOf("a.csv", "t,x,y,p\n");
  EXPECT_TRUE(holds(run("verify " + csv), "there is no " + csv + ".json"));
  EXPECT_TRUE(holds(run("convert --size 3x2 " + csv + " " + folder_.at("a.xyz")), ".csv csv ("));
  EXPECT_TRUE(holds(run("convert --size 3x2 --format abc " + csv + " " + folder_.at("a.txt")),
                    "--format: 'abc' is not known"));
  EXPECT_TRUE(holds(run("convert --size 3x2 " + folder_.at("a.png") + " " + folder_.at("a.txt")),
                    "has no extension that can be read; known are "));
}

}  // namespace
}  // namespace saccade
