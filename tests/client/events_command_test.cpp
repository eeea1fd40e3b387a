// `saccade events`: a bar that grows brighter, as raw float.
#include <algorithm>
#include <cmath>
#include <fstream>

#include "client/command.h"

namespace saccade {
namespace {

namespace fs = std::filesystem;
using namespace test;

constexpr int kWidth = 8, kHeight = 4, kFrames = 41;
constexpr double kStep = 0.05;  // of log brightness, in each frame, at the pixels of one column

class EventsCommand : public CommandAndServer {
 protected:
  EventsCommand() {
    std::ofstream out(video_, std::ios::binary);
    for (int frame = 0; frame < kFrames; ++frame) {
      for (int i = 0; i < kWidth * kHeight; ++i) {
        const float light = i % kWidth == 3 ? static_cast<float>(std::exp(kStep * frame)) : 1;
        out.write(reinterpret_cast<const char*>(&light), sizeof light);
      }
    }
  }
  Result events(const std::string& frames, const std::string& options) const {
    return run("events " + frames + " --rate 100 " + options + server_.option());
  }
  const std::string video_ = folder_.at("video.f32"), csv_ = folder_.at("a.csv");
  const std::string size_ = "--size 8x4 --bias 1e-9 --threshold 0.2 -o " + csv_ + " ";
};

// In 40 steps the column brightens by 10 thresholds.
TEST_F(EventsCommand, MakesEventsWhereTheVideoChanges) {
  const Result result = events(video_, size_ + "--truth frame16:20 --preview " + folder_.at("a.png"));
  ASSERT_EQ(result.code, 0) << result.output;
  EXPECT_TRUE(holds(result, "0.4 s of the stream")) << result.output;
  EXPECT_TRUE(holds(result, "frame16 2")) << result.output;
  std::ifstream in(csv_);
  std::string line;
  std::getline(in, line);
  int count = 0;
  for (int t, x, y, p; std::getline(in, line); ++count) {
    ASSERT_EQ(std::sscanf(line.c_str(), "%d,%d,%d,%d", &t, &x, &y, &p), 4) << line;
    EXPECT_TRUE(x == 3 && p == 1) << line;
  }
  EXPECT_GE(count, 9 * kHeight);
  EXPECT_LE(count, 11 * kHeight);
  EXPECT_GT(fs::file_size(folder_.at("a.csv.truth/frame16/000001.png")), 50u);
}

TEST_F(EventsCommand, ReadsTheStandardInput) {
  ASSERT_EQ(events(video_, size_).code, 0);
  const std::string from_file = textOf(csv_);
  const Result piped = events("- < " + video_, size_ + "--force");
  ASSERT_EQ(piped.code, 0) << piped.output;
  EXPECT_EQ(textOf(csv_), from_file);
}

TEST_F(EventsCommand, IsVerifiedButNotReplayed) {
  ASSERT_EQ(events(video_, size_).code, 0);
  EXPECT_EQ(run("verify " + csv_).code, 0);
  const Result replayed = run("replay " + csv_ + ".json -o " + folder_.at("b.csv") + server_.option());
  EXPECT_EQ(replayed.code, 2);
  EXPECT_TRUE(holds(replayed, "use `saccade events` again")) << replayed.output;
}

TEST_F(EventsCommand, ABagTellsNoCameraThatIsNotKnown) {
  const std::string bag = folder_.at("a.bag");
  ASSERT_EQ(events(video_, "--size 8x4 -o " + bag).code, 0);
  EXPECT_EQ(textOf(bag).find("sensor_msgs/CameraInfo"), std::string::npos);
}

TEST_F(EventsCommand, TellsWhatIsWrong) {
  const auto expect = [](const Result& result, int code, const std::string& text) {
    EXPECT_EQ(result.code, code);
    EXPECT_TRUE(holds(result, text)) << result.output;
  };
  expect(events("none.png", "-o " + csv_), 2, "FRAMES: there is no file 'none.png'");
  expect(events(video_, "-o " + csv_), 2, "raw frames need --size");
  expect(events("- < " + video_, "-o " + csv_), 2, "FRAMES: the standard input has raw frames: give --size");
  expect(events(folder_.at(""), "-o " + csv_), 2, "FRAMES: events need at least two frames");
  expect(events(folder_.at(""), size_), 2, "is a folder: with --size, frames are raw files");
  expect(events(folder_.at("a.mp4"), "-o " + csv_), 2, "there is no file");
  std::ofstream(folder_.at("a.mp4")) << "no frames";
  expect(events(folder_.at("a.mp4"), "-o " + csv_), 2,
         "a.mp4 -f rawvideo -pix_fmt grayf32le - | saccade events -");
  expect(events(video_, "--size 10000x10000 -o " + csv_), 2, "but this one has 10000x10000");
  expect(events(video_, "--size 8 -o " + csv_), 2, "--size");
  expect(events(video_, size_ + "--truth depth"), 2, "depth needs a scene");
  expect(events(video_, "--size 8x3 -o " + csv_), 1, "ends within a frame");
  expect(events(video_, "--size 8x4 --transfer gamma -o " + csv_), 2, "--transfer");
  expect(events("- < /dev/null", size_ + "--force"), 1, "events need at least two frames");
}

TEST_F(EventsCommand, TellsThatNumbersFallInAList) {
  const std::string nine = folder_.at("9.f32"), ten = folder_.at("10.f32");
  for (const std::string& file : {nine, ten}) fs::copy_file(video_, file);
  const Result falling = events(ten + " " + nine, size_),
               rising = events(nine + " " + ten, size_ + "--force");
  EXPECT_EQ(falling.code + rising.code, 0);
  EXPECT_TRUE(holds(falling, "10.f32' comes before '")) << falling.output;
  EXPECT_FALSE(holds(rising, "warning")) << rising.output;
}

// From 0 to 1 at bias 0.001 are ln(1001) / 0.2 = 34.54 thresholds.
TEST_F(EventsCommand, NamesTheOptionThatGivesAllEventsOfAStep) {
  constexpr int kPixels = kWidth * kHeight;
  {
    std::ofstream out(video_, std::ios::binary);
    const std::vector<float> dark(kPixels, 0), light(kPixels, 1);
    for (const auto& frame : {dark, light})
      out.write(reinterpret_cast<const char*>(frame.data()), kPixels * 4);
  }
  const std::string step = "--size 8x4 --bias 1e-3 --threshold 0.2 -o " + csv_ + " --force ";
  const auto count = [&] {
    const std::string text = textOf(csv_);
    return std::count(text.begin(), text.end(), '\n') - 1;
  };
  const Result few = events(video_, step);
  EXPECT_EQ(count(), 32 * kPixels);
  EXPECT_TRUE(holds(few, "limits are 32 per pixel and interval, which --max-events raises")) << few.output;
  const Result all = events(video_, step + "--max-events 64");
  EXPECT_FALSE(holds(all, "withheld")) << all.output;
  EXPECT_GE(count(), 34 * kPixels);
  EXPECT_LE(count(), 35 * kPixels);
  EXPECT_TRUE(holds(events(video_, step + "--max-events 0"), "--max-events"));
}

TEST_F(EventsCommand, NamesAFrameThatCannotBe) {
  std::fstream out(video_, std::ios::binary | std::ios::in | std::ios::out);
  const float dark = -1;
  out.seekp(5 * kWidth * kHeight * 4).write(reinterpret_cast<const char*>(&dark), sizeof dark);
  out.close();
  const Result result = events(video_, size_);
  EXPECT_EQ(result.code, 1);
  EXPECT_TRUE(holds(result, "frame 5: intensity[0]: -1 is outside")) << result.output;
}

}  // namespace
}  // namespace saccade
