#include "farm/card/write_card.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "client/scratch_folder.h"
#include "farm/card/licences.h"
#include "farm/card/statistics.h"
#include "farm/recipe/recipe_reader.h"
#include "farm/small_data_set.h"
#include "farm/worker/failures.h"

namespace saccade::farm {
namespace {

namespace fs = std::filesystem;

class CardTest : public testing::Test {
 protected:
  CardTest() {
    putText(scratch_.at("scenes/cornell-box/README.md"), "# box\n\nLicence: MIT,\nof us\n\nMore.\n");
  }
  Statistics statistics() const {
    return statisticsOf(set_, readRecipe(set_.recipeFolder() / kRecipeFile), [](std::uint64_t) {});
  }
  CardResult write(CardOptions options = {}) {
    options.folder = set_.folder();
    options.scenes = scratch_.at("scenes");
    return writeCard(
        options, [&](const std::string& fault) { told_ += fault; }, [](std::uint64_t) {});
  }
  std::string page() const { return readText(set_.folder() / "README.md"); }
  bool tells(const std::string& text) const { return page().find(text) != std::string::npos; }

  ScratchFolder scratch_;
  const DataSet set_ = makeSmallDataSet(scratch_.at("set"));
  std::string told_;
};

TEST_F(CardTest, CountsWhatIsThere) {
  const Statistics found = statistics();
  constexpr std::uint64_t kAll = kSmallSequences;
  EXPECT_EQ(found.all.sequences, kAll);
  EXPECT_EQ(found.all.events, 10 * kAll * (kAll + 1) / 2);
  EXPECT_DOUBLE_EQ(found.all.duration_s, kSmallDuration_s * kAll);
  EXPECT_EQ(found.splits.at("test").sequences, 2u);
  EXPECT_EQ(found.splits.at("test").events, smallEvents(2) + smallEvents(5));
  EXPECT_EQ(found.scenes.at("cornell-box"), 3u);
  EXPECT_EQ(found.sizes.at("8x4"), kAll);
  EXPECT_EQ(found.texts.at("scene").at("nowhere"), 3u);
}

TEST_F(CardTest, TellsLeastMiddleAndGreatest) {
  const Statistics found = statistics();
  const Numbers::Summary events = found.events.summary(), rate = found.rate.summary(),
                         speed = found.numbers.at("speed").summary();
  EXPECT_EQ(events.min, 10);
  EXPECT_EQ(events.median, 35);  // between 30 and 40
  EXPECT_EQ(events.max, 60);
  const double pixel_seconds = kSmallDuration_s * kSmallWidth * kSmallHeight;
  EXPECT_DOUBLE_EQ(rate.min, 10 / pixel_seconds);
  EXPECT_DOUBLE_EQ(rate.max, 60 / pixel_seconds);
  EXPECT_DOUBLE_EQ(speed.min, 0.1);
  EXPECT_DOUBLE_EQ(speed.max, 0.6);
  // Six numbers of equal distance in twelve bins.
  EXPECT_EQ(events.bins, (std::array<std::uint64_t, 12>{1, 0, 1, 0, 1, 0, 0, 1, 0, 1, 0, 1}));
}

TEST_F(CardTest, AnEventThatTwoFilesHoldCountsOnce) {
  v1::DataSetSequence sequence =
      readJson<v1::DataSetSequence>(set_.sequenceFolder(smallSequence(0)) / kSequenceFile);
  v1::DataSetRecording copy = sequence.recordings(0);
  copy.set_file("events.h5");
  *sequence.add_recordings() = copy;
  copy.set_sensor(1);
  *sequence.add_recordings() = copy;
  putText(set_.indexFile(0), jsonLine(sequence));
  fs::remove(set_.indexFile(1));
  EXPECT_EQ(statistics().all.events, 2 * smallEvents(0));
  EXPECT_EQ(statistics().shards, 1u);
}

TEST_F(CardTest, ThePageTellsWhatIsThere) {
  const CardResult result = write();
  EXPECT_EQ(told_, "");
  EXPECT_EQ(result.unfinished, 0u);
  EXPECT_EQ(result.unknown_licences, std::vector<std::string>{"nowhere"});
  EXPECT_TRUE(tells("# small\n"));
  EXPECT_TRUE(tells("| `test` | 2 | 90 | 0.2 s |")) << page();
  EXPECT_TRUE(tells("| all | 6 | 210 | 0.6 s |")) << page();
  EXPECT_TRUE(tells("uniform in \\[0.1, 0.7\\]")) << page();
  EXPECT_TRUE(tells("| `speed` | 0.1 | 0.35 | 0.6 |")) << page();
  EXPECT_TRUE(tells("| `cornell-box` | MIT, of us |")) << page();
  EXPECT_TRUE(tells("| `nowhere` | **not known** |")) << page();
  EXPECT_TRUE(tells(set_.plan().recipe_digest()));
  EXPECT_TRUE(fs::exists(set_.folder() / "card/sequences.png"));
}

TEST_F(CardTest, TwoCardsOfADataSetAreEqual) {
  write();
  const std::string before =
      page() + readText(set_.folder() / "croissant.json") + readText(set_.folder() / "card/sequences.png");
  write();
  EXPECT_EQ(
      page() + readText(set_.folder() / "croissant.json") + readText(set_.folder() / "card/sequences.png"),
      before);
  EXPECT_EQ(before.find(scratch_.at("")), std::string::npos) << "no path of this machine";
}

TEST_F(CardTest, TellsWhatFailedAndWhatIsNotThere) {
  fs::remove_all(set_.sequenceFolder(smallSequence(0)));
  std::string index = readText(set_.indexFile(0));
  putText(set_.indexFile(0), index.substr(index.find('\n') + 1));
  recordFailure(set_, smallSequence(0), "no | such\nscene", false);
  fs::remove(set_.indexFile(1));
  EXPECT_EQ(write().unfinished, 1u);
  EXPECT_TRUE(tells("1 of its 2 shards")) << page();
  EXPECT_TRUE(tells("| 0 | no \\| such scene |")) << page();
}

TEST_F(CardTest, APictureThatCannotBeDrawnIsTold) {
  putText(set_.sequenceFolder(smallSequence(0)) / "events.csv", "nonsense\n");
  write();
  EXPECT_NE(told_.find("no picture of sequence 000000"), std::string::npos) << told_;
}

TEST(Numbers, TheMedianOfAnOddCountIsTheMiddle) {
  Numbers numbers;
  for (const double number : {7, 1, 2}) numbers.add(number);
  EXPECT_EQ(numbers.summary().median, 2);
  Numbers equal;
  for (int i = 0; i < 3; ++i) equal.add(5);
  EXPECT_EQ(equal.summary().bins[0], 3u);
  EXPECT_EQ(equal.summary().max, 5);
}

TEST(Licences, AreParagraphsOfAPage) {
  ScratchFolder scratch;
  const auto of = [&](const std::string& text) {
    putText(scratch.at("a/README.md"), text);
    return licenceOf(scratch.at(""), "a");
  };
  EXPECT_EQ(of("# a\n\nLicence: CC0\n"), "CC0");
  EXPECT_EQ(of("License: MIT\nand more\n\nno more"), "MIT and more");
  EXPECT_EQ(of("# a\n\nThe licence: CC0\nLicence:\n"), "");
  EXPECT_EQ(licenceOf(scratch.at(""), "b"), "");
}

}  // namespace
}  // namespace saccade::farm
