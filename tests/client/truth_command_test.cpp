// `saccade record --truth`, and what `convert`, `verify` and `replay` make of such files.
#include "client/command.h"
#include "client/recording/sidecar.h"

namespace saccade {
namespace {

namespace fs = std::filesystem;
using namespace test;

class TruthCommand : public CommandAndServer {
 protected:
  Result record(const std::string& options) const {
    return run("record cornell-box --trajectory right --size 32x24 --rate 1000 --duration 0.02 " + options +
               server_.option());
  }
  const std::string csv_ = folder_.at("a.csv");
};

TEST_F(TruthCommand, ChangesNoEventAndTellsTheSamples) {
  ASSERT_EQ(record("-o " + csv_).code, 0);
  const std::string beside = folder_.at("b.csv");
  const Result result = record("--truth depth:5 --truth pose -o " + beside);
  EXPECT_EQ(result.code, 0);
  EXPECT_TRUE(holds(result, "samples of truth in " + beside + ".truth: depth 5, pose 21\n")) << result.output;
  EXPECT_EQ(textOf(beside), textOf(csv_));
  EXPECT_GT(fs::file_size(beside + ".truth/depth/000004.exr"), 100u);
  const v1::Recording recording = *client::recordingOf(beside);
  EXPECT_EQ(recording.truth(0).info().planes(0), "z");
  EXPECT_EQ(recording.truth(1).samples(), 21u);
}

TEST_F(TruthCommand, EachViewHasItsTruthAndTheBodyItsImu) {
  const Result result =
      record("--further-view 0.1,0,0 --truth depth:10 --truth imu --write-calibration -o " + csv_);
  const std::string left = folder_.at("a-0.csv"), right = folder_.at("a-1.csv");
  ASSERT_EQ(result.code, 0) << result.output;
  EXPECT_TRUE(
      holds(result, "samples of truth in " + left + ".truth " + right + ".truth: depth 3, imu 4, depth 3\n"))
      << result.output;
  EXPECT_NE(textOf(left + ".truth/depth/000000.exr"), textOf(right + ".truth/depth/000000.exr"));
  EXPECT_FALSE(fs::exists(right + ".truth/imu.csv"));
  const v1::Recording recording = *client::recordingOf(right);
  EXPECT_EQ(recording.request().sensors(static_cast<int>(recording.sensor())).view(), 1u);
  EXPECT_EQ(recording.request().further_views(0).body_camera().position().x(), 0.1);
  EXPECT_TRUE(textOf(csv_ + ".imu.yaml").ends_with("update_rate: 200.0\n")) << textOf(csv_ + ".imu.yaml");
  EXPECT_TRUE(fs::exists(csv_ + ".cam1.camera_info.yaml"));
}

TEST_F(TruthCommand, AFolderOfTruthIsKeptUnlessForced) {
  fs::create_directory(csv_ + ".truth");
  const Result kept = record("--truth pose -o " + csv_);
  EXPECT_EQ(kept.code, 2);
  EXPECT_TRUE(holds(kept, "a.csv.truth' exists; --force replaces it")) << kept.output;
  EXPECT_EQ(record("--truth pose --force -o " + csv_).code, 0);
  EXPECT_TRUE(fs::exists(csv_ + ".truth/pose.csv"));
  const std::string right = folder_.at("a-1.csv.truth");
  fs::create_directory(right);
  const Result stereo = record("--further-view 0.1,0,0 --truth pose -o " + csv_);
  EXPECT_TRUE(holds(stereo, right + "' exists")) << stereo.output;
}

TEST_F(TruthCommand, WrongUsageIsTold) {
  const Result unknown = record("--truth dept -o " + csv_);
  EXPECT_EQ(unknown.code, 2);
  EXPECT_TRUE(holds(unknown, "there is no truth channel 'dept'; there are: depth")) << unknown.output;
  for (const char* wrong : {"depth:0", "depth:x", ":3", "depth:"}) {
    const Result result = record("--truth " + std::string(wrong) + " -o " + csv_);
    EXPECT_EQ(result.code, 2);
    EXPECT_TRUE(holds(result, "is neither NAME nor NAME:EVERY")) << result.output;
  }
  EXPECT_TRUE(holds(record("--truth pose -o -"), "--truth: standard output takes events only"));
  EXPECT_FALSE(fs::exists(csv_));
}

TEST_F(TruthCommand, InfoListsTheChannels) {
  const Result info = run("info" + server_.option());
  EXPECT_TRUE(holds(info, "truth channels (record --truth)")) << info.output;
  EXPECT_TRUE(holds(info, "row: x, y, z, qx, qy, qz, qw (scene units)  T_world_camera")) << info.output;
}

TEST_F(TruthCommand, OtherCommandsTakeTheEventsAndSayWhatTheyLeaveOut) {
  const std::string out = folder_.at("out.txt");
  for (const char* name : {"a.h5", "a.npz", "a.csv"}) {
    const std::string file = folder_.at(name);
    ASSERT_EQ(record("--truth pose --truth depth -o " + file).code, 0);
    const std::string told = file == csv_                 ? "left out: " + csv_ + ".truth"
                             : file == folder_.at("a.h5") ? "left out: the truth channels of /truth"
                                                          : "left out: truth pose, depth";
    const Result verified = run("verify " + file);
    EXPECT_EQ(verified.code, 0);
    EXPECT_TRUE(holds(verified, told) && holds(verified, "are as recorded")) << verified.output;
    const Result converted = run("convert --force " + file + " " + out);
    EXPECT_EQ(converted.code, 0);
    EXPECT_TRUE(holds(converted, told)) << converted.output;
    EXPECT_EQ(client::recordingOf(out)->truth_size(), 0);
  }
  const std::string again = folder_.at("again.npz");
  const Result replayed = run("replay " + csv_ + ".json -o " + again + server_.option());
  EXPECT_TRUE(holds(replayed, "the events are those of the recording")) << replayed.output;
  EXPECT_TRUE(holds(replayed, "samples of truth in " + again + ": pose 21, depth 21")) << replayed.output;
}

}  // namespace
}  // namespace saccade
