#include "farm/worker/make_sequence.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <optional>

#include "farm/dataset/file_digest.h"
#include "farm/dataset/json_file.h"
#include "farm/recipe_file.h"
#include "farm/worker/failures.h"
#include "farm/worker/sequence_folder.h"
#include "scene/library/find_scenes.h"

namespace saccade::farm {
namespace {

constexpr const char* kPlan =
    R"({"name":"a","sequences":"3","shards":2,"outputs":["a.h5","a.raw"],"software_version":"0.1.0"})";

struct MakeSequenceTest : testing::Test {
  MakeSequenceTest() {
    folder.write("plan.json", kPlan);
    set.emplace(folder.folder);
  }
  v1::DataSetSequence sequence(std::uint64_t number, std::vector<std::string> more = {}) const {
    v1::DataSetSequence sequence;
    sequence.set_number(number);
    sequence.set_shard(number < 2 ? 0 : 1);
    sequence.set_split("all");
    for (const char* word : {"cornell-box", "--motion=pan:20", "--size=16x12", "--rate=500"})
      sequence.add_options(word);
    if (more.empty()) more = {"--duration=0.02"};
    for (const std::string& word : more) sequence.add_options(word);
    return sequence;
  }
  Made make(const v1::DataSetSequence& sequence) { return makeSequence(*set, sequence, "w.0", renderer); }

  const RecipeFile folder{""};
  std::optional<DataSet> set;
  SequenceRenderer renderer{
      {.scenes = findScenes(), .meshes = kDefaultMeshes, .bakes = {}, .accuracy = {}, .simplification = {}},
      1};
};

TEST_F(MakeSequenceTest, PublishesFilesWithTheirDigests) {
  const v1::DataSetSequence planned = sequence(1);
  ASSERT_EQ(make(planned), Made::kDone);
  const auto about = readJson<v1::DataSetSequence>(set->sequenceFolder(planned) / kSequenceFile);
  ASSERT_EQ(about.files_size(), 4);
  for (const v1::DataSetFile& file : about.files()) {
    EXPECT_EQ(file.digest(), digestOfFile(set->sequenceFolder(planned) / file.name()));
    EXPECT_EQ(file.bytes(), std::filesystem::file_size(set->sequenceFolder(planned) / file.name()));
  }
  ASSERT_EQ(about.recordings_size(), 2);
  EXPECT_EQ(about.recordings(0).file(), "a.h5");
  EXPECT_EQ(about.recordings(1).end_ns(), 20'000'000);
  EXPECT_GT(about.recordings(0).events(), 0u);
  EXPECT_EQ(about.recordings(0).events(), about.recordings(1).events());
  EXPECT_TRUE(std::filesystem::is_empty(set->partialFolder()));
}

TEST_F(MakeSequenceTest, NamesTheNumbersOfObjects) {
  const v1::DataSetSequence planned = sequence(
      1, {"--duration=0.004", "--object=tall_block=spin:90", "--truth=object_poses", "--write-poses"});
  ASSERT_EQ(make(planned), Made::kDone);
  const auto about = readJson<v1::Recording>(set->sequenceFolder(planned) / "a.h5.json");
  EXPECT_GT(about.id_names().objects_size(), 0);
  EXPECT_TRUE(std::filesystem::exists(set->sequenceFolder(planned) / "a.h5.object-tall_block.tum.txt"));
}

TEST_F(MakeSequenceTest, ASecondWorkerDoesNoHarm) {
  const v1::DataSetSequence planned = sequence(1);
  ASSERT_EQ(make(planned), Made::kDone);
  const std::string digest = digestOfFolder(set->sequenceFolder(planned));
  EXPECT_EQ(make(planned), Made::kDone);
  EXPECT_EQ(digestOfFolder(set->sequenceFolder(planned)), digest);
  EXPECT_TRUE(std::filesystem::is_empty(set->partialFolder()));
}

TEST_F(MakeSequenceTest, ReplacesAFolderThatIsNoWholeSequence) {
  const v1::DataSetSequence planned = sequence(1);
  ASSERT_EQ(make(planned), Made::kDone);
  const std::string digest = digestOfFolder(set->sequenceFolder(planned));
  std::filesystem::remove(set->sequenceFolder(planned) / kSequenceFile);
  std::filesystem::remove(set->sequenceFolder(planned) / "a.raw");
  ASSERT_EQ(make(planned), Made::kDone);
  EXPECT_EQ(digestOfFolder(set->sequenceFolder(planned)), digest);
}

TEST_F(MakeSequenceTest, TheOrderOfSequencesDoesNotMatter) {
  SequenceRenderer other{
      {.scenes = findScenes(), .meshes = kDefaultMeshes, .bakes = {}, .accuracy = {}, .simplification = {}},
      2};
  const v1::DataSetSequence first = sequence(0), second = sequence(1);
  ASSERT_EQ(make(first), Made::kDone);
  ASSERT_EQ(make(second), Made::kDone);
  const std::string digest = digestOfFolder(set->shardFolder(0));
  std::filesystem::remove_all(set->shardFolder(0));
  ASSERT_EQ(makeSequence(*set, second, "w.1", other), Made::kDone);
  ASSERT_EQ(makeSequence(*set, first, "w.1", other), Made::kDone);
  EXPECT_EQ(digestOfFolder(set->shardFolder(0)), digest);
}

TEST_F(MakeSequenceTest, PutsWhatCanNeverBeOnRecord) {
  const v1::DataSetSequence wrong = sequence(2, {"--truth=nothing"});
  EXPECT_EQ(make(wrong), Made::kNever);
  const auto failure = failureOf(*set, wrong);
  ASSERT_TRUE(failure);
  EXPECT_NE(failure->message().find("nothing"), std::string::npos);
  EXPECT_FALSE(failure->retry());
  EXPECT_FALSE(isPublished(*set, wrong));
  EXPECT_TRUE(settleShard(*set, 1, {wrong}));
  EXPECT_EQ(readText(set->indexFile(1)), "");
}

TEST_F(MakeSequenceTest, ForgetsAFailureThatIsMended) {
  const v1::DataSetSequence planned = sequence(2);
  recordFailure(*set, planned, "the disk is full", true);
  EXPECT_FALSE(settleShard(*set, 1, {planned}));
  ASSERT_EQ(make(planned), Made::kDone);
  EXPECT_FALSE(failureOf(*set, planned));
  EXPECT_TRUE(settleShard(*set, 1, {planned}));
  EXPECT_EQ(readText(set->indexFile(1)), readText(set->sequenceFolder(planned) / kSequenceFile));
}

TEST_F(MakeSequenceTest, RemovesAnIndexThatAKilledRunHasBegun) {
  const v1::DataSetSequence planned = sequence(2);
  ASSERT_EQ(make(planned), Made::kDone);
  const std::string begun = set->indexFile(1).string() + ".AbCdEf";
  std::ofstream(begun) << "a part";
  EXPECT_TRUE(settleShard(*set, 1, {planned}));
  EXPECT_FALSE(std::filesystem::exists(begun));
  EXPECT_TRUE(std::filesystem::exists(set->indexFile(1)));
}

TEST_F(MakeSequenceTest, GivesUpWhatKillsWorkers) {
  const v1::DataSetSequence planned = sequence(0);
  EXPECT_TRUE(recordCrash(*set, planned, "killed").retry());
  EXPECT_TRUE(recordCrash(*set, planned, "killed").retry());
  EXPECT_FALSE(recordCrash(*set, planned, "killed").retry());
}

}  // namespace
}  // namespace saccade::farm
