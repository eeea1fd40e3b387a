// `saccade record`.
#include <fstream>
#include <iterator>

#include "client/command.h"
#include "mock/accuracy_file.h"

namespace saccade {
namespace {

namespace fs = std::filesystem;
using namespace test;

TEST_F(CommandAndServer, RecordsASensorPerThreshold) {
  const std::string file = folder_.at("a.csv"), picture = folder_.at("a.png");
  const Result result =
      run("record cornell-box --trajectory right --size 32x24 --duration 0.06 --threshold 0.2 "
          "--threshold 0.4 -o " +
          file + " --preview " + picture + server_.option());
  ASSERT_EQ(result.code, 0) << result.output;
  EXPECT_TRUE(holds(result, "wrote " + folder_.at("a-0.csv"))) << result.output;
  EXPECT_TRUE(holds(result, "trace ")) << result.output;
  EXPECT_TRUE(holds(result, "the picture moves by 4") && holds(result, "pixels per second")) << result.output;
  EXPECT_GT(fs::file_size(folder_.at("a-0.csv")), fs::file_size(folder_.at("a-1.csv")));
  EXPECT_GT(fs::file_size(picture), 100u);
}
TEST(Record, ThePreviewIsAPng) {
  const Result result = run("record cornell-box --trajectory right -o a.csv --preview a.jpg");
  EXPECT_EQ(result.code, 2);
  EXPECT_TRUE(holds(result, "--preview: 'a.jpg' is not a .png file")) << result.output;
}
TEST(CommandAndKeys, RecordsFromAServerThatWantsThem) {
  const ScratchFolder folder;
  const std::string server = folder.at("server"), alice = folder.at("alice"), file = folder.at("a.csv");
  ASSERT_EQ(run("keygen " + server).code, 0);
  ASSERT_EQ(run("keygen " + alice).code, 0);
  fs::copy_file(alice + ".pub", folder.at("clients"));
  const Server daemon("--secret-key " + server + ".key --client-keys " + folder.at("clients"));
  const std::string keys = " --secret-key " + alice + ".key --server-key " + server + ".pub ";
  const std::string record = "record cornell-box --trajectory right --size 32x24 --duration 0.01 -o " + file;
  const Result without = run("info --wait 0.2 " + daemon.option());
  EXPECT_EQ(without.code, 1);
  EXPECT_TRUE(holds(without, "it wants keys: give --secret-key and --server-key")) << without.output;
  EXPECT_EQ(run("info --secret-key " + alice + ".key" + daemon.option()).code, 2);
  EXPECT_EQ(run(record + keys + daemon.option()).code, 0);
  EXPECT_TRUE(fs::exists(file));
}
TEST(CommandAndBudget, TellsTheChoiceAndTheExpectedQuality) {
  const ScratchFolder folder;
  const AccuracyFile table(folder.at("chart"));
  const Server server("--accuracy " + table.path());
  const Result info = run("info" + server.option());
  EXPECT_TRUE(holds(info, "--budget-ms, --max-false-rate) for: cornell-box\n")) << info.output;
  EXPECT_TRUE(holds(info, table.settings())) << info.output;
  const std::string record =
      "record cornell-box --trajectory right --size 32x24 --rate 1000 --duration 0.01 --threshold 0.1 -o " +
      folder.at("a.csv") + server.option();
  const Result chosen = run(record + "--budget-ms 4 --method svgf");
  EXPECT_EQ(chosen.code, 0);
  EXPECT_TRUE(holds(chosen, "chosen: svgf:as_falcor=1 at 1 spp\n")) << chosen.output;
  EXPECT_TRUE(holds(chosen, "3 CPU ms per frame, 0.1 false and 0.12 missed events")) << chosen.output;
  EXPECT_TRUE(holds(chosen, table.settings())) << chosen.output;
  const Result refused = run(record + "--max-false-rate 0.001 --force");
  EXPECT_EQ(refused.code, 2);
  EXPECT_TRUE(holds(refused, "--max-false-rate: the lowest rate here")) << refused.output;
}
TEST_F(CommandAndServer, TheCalibrationStandsBesideTheRecording) {
  const std::string record =
      "record cornell-box --trajectory right --size 32x24 --duration 0.01 --write-calibration "
      "--intrinsics 40,41,15,12.5 --distortion radtan:-0.1,0.02,0.001,-0.002 -o " +
      folder_.at("a.h5") + server_.option();
  const Result result = run(record);
  ASSERT_EQ(result.code, 0) << result.output;
  for (const char* ending : {".camera_info.yaml", ".kalibr.yaml", ".cam_to_cam.yaml"}) {
    std::ifstream file(folder_.at("a.h5") + ending);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    EXPECT_NE(text.find("[-0.1, 0.02, 0.001, -0.002"), text.npos) << ending << text;
    EXPECT_NE(text.find("12.5"), text.npos) << ending << text;
  }
  fs::remove(folder_.at("a.h5")), fs::remove(folder_.at("a.h5.json"));
  const Result again = run(record);
  EXPECT_EQ(again.code, 2);
  EXPECT_TRUE(holds(again, "--write-calibration: ")) << again.output;
}
TEST_F(CommandAndServer, AnExistingFileIsKeptUnlessForced) {
  const std::string record = "record cornell-box --trajectory right --size 32x24 --duration 0.01 -o " +
                             folder_.at("a.csv") + server_.option();
  ASSERT_EQ(run(record).code, 0);
  const Result again = run(record);
  EXPECT_EQ(again.code, 2);
  EXPECT_TRUE(holds(again, "exists; --force replaces it")) << again.output;
  EXPECT_EQ(run(record + "--force").code, 0);
}
TEST_F(CommandAndServer, StandardOutputHoldsTheEventsAlone) {
  const std::string record = "record cornell-box --trajectory right --size 32x24 --duration 0.02 -o ";
  const std::string file = folder_.at("a.csv"), piped = folder_.at("b.csv");
  ASSERT_EQ(run(record + file + server_.option()).code, 0);
  Child child("sh -c \"" SACCADE_COMMAND " " + record + "- " + server_.option() + " >" + piped + "\"");
  const Result result = finish(child);
  EXPECT_EQ(result.code, 0) << result.output;
  EXPECT_TRUE(holds(result, "wrote to standard output")) << result.output;
  EXPECT_EQ(textOf(piped), textOf(file));
}
TEST_F(CommandAndServer, TellsHowIntervalsFollowTheMotion) {
  const std::string record = "record cornell-box --motion truck:20 --size 32x24 --duration 0.2 --force -o " +
                             folder_.at("a.csv") + server_.option();
  const Result result = run(record);
  ASSERT_EQ(result.code, 0) << result.output;
  for (const char* told : {" pixels per second (median; ",
                           "rendered every 1 px of motion, 100 to 1000 times per second, and pixels that "
                           "change in between every 0.0625 px\n",
                           "CPU s per second of the stream: "})
    EXPECT_TRUE(holds(result, told)) << result.output;
  EXPECT_FALSE(holds(result, "warning")) << result.output;
  const Result slow = run(record + " --min-rate 5 --max-rate 5");
  EXPECT_TRUE(holds(slow, "pixels in an interval; --max-rate ")) << slow.output;
  const Result whole = run(record + " --method event_svgf");
  EXPECT_TRUE(holds(whole, "1000 times per second\n")) << whole.output;
}
TEST_F(CommandAndServer, AsksForARateWhereItIsNeeded) {
  const Result result = run("record cornell-box --motion truck:0.5px --size 32x24 --duration 0.02 -o " +
                            folder_.at("a.csv") + server_.option());
  EXPECT_NE(result.code, 0);
  EXPECT_TRUE(holds(result, "--rate")) << result.output;
}
TEST_F(CommandAndServer, AFastPictureGetsTheRateThatWouldDo) {
  const Result fast = run("record cornell-box --trajectory right --size 64x48 --rate 50 --duration 0.04 -o " +
                          folder_.at("a.csv") + server_.option());
  EXPECT_EQ(fast.code, 0);
  const std::string mark = "above half a pixel per frame events are less accurate; --rate ";
  ASSERT_TRUE(holds(fast, mark)) << fast.output;
  const std::string rate = fast.output.substr(fast.output.find(mark) + mark.size(), 4);
  const Result slow = run("record cornell-box --trajectory right --size 64x48 --duration 0.04 --rate " +
                          rate.substr(0, rate.find(' ')) + " -o " + folder_.at("b.csv") + server_.option());
  EXPECT_EQ(slow.code, 0);
  EXPECT_FALSE(holds(slow, "above half a pixel")) << slow.output;
}

}  // namespace
}  // namespace saccade
