#include "farm/report/verify.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "client/scratch_folder.h"
#include "farm/small_data_set.h"
#include "farm/worker/failures.h"

namespace saccade::farm {
namespace {

namespace fs = std::filesystem;

class VerifyTest : public testing::Test {
 protected:
  // All that verify() tells, sorted: folders have no order.
  std::vector<std::string> told() {
    std::vector<std::string> lines;
    steps_ = 0;
    found_ = verify(
        set_, [&](const std::string& line) { lines.push_back(line); }, [&](const Verified&) { ++steps_; });
    std::ranges::sort(lines);
    return lines;
  }
  fs::path at(const std::string& name) const { return set_.folder() / name; }

  ScratchFolder scratch_;
  const DataSet set_ = makeSmallDataSet(scratch_.at("set"));
  Verified found_ = {};
  std::uint64_t steps_ = 0;
};

using Lines = std::vector<std::string>;

TEST_F(VerifyTest, AWholeDataSetHasNoFault) {
  EXPECT_EQ(told(), Lines{});
  EXPECT_TRUE(found_.whole());
  EXPECT_EQ(found_.sequences, kSmallSequences);
  EXPECT_EQ(steps_, kSmallSequences);
  std::uint64_t bytes = 0;
  for (std::uint64_t i = 0; i < kSmallSequences; ++i)
    bytes += smallCsv(i).size() + std::string("index,t_us\n").size();
  EXPECT_EQ(found_.bytes, bytes);
}

TEST_F(VerifyTest, WhatFarmsMakeLaterIsNotForeign) {
  for (const char* name : {"card", "webdataset", "workers", "partial"}) fs::create_directories(at(name));
  putText(at("README.md"), "");
  putText(at("croissant.json"), "");
  EXPECT_EQ(told(), Lines{});
}

TEST_F(VerifyTest, NamesEachDamagedFile) {
  std::string csv = smallCsv(1);
  csv.back() = ' ';
  putText(at("shards/00000/000001/events.csv"), csv);
  putText(at("shards/00000/000002/events.csv"), "short");
  putText(at("shards/00001/000003/sequence.json"), "{");
  putText(at("recipe/recipe.toml"), "");
  EXPECT_EQ(told(), (Lines{"damaged: recipe differs from its digest",
                           "damaged: shards/00000/000001/events.csv differs from its digest",
                           "damaged: shards/00000/000002/events.csv has 5 bytes instead of " +
                               std::to_string(smallCsv(2).size()),
                           "damaged: shards/00001/000003/sequence.json is no description of a sequence"}));
  EXPECT_EQ(found_.sequences, kSmallSequences - 3);
}

TEST_F(VerifyTest, NamesEachMissingFile) {
  fs::remove(at("shards/00000/000000/events.csv.truth/depth/times.csv"));
  fs::remove_all(at("shards/00000/000001"));
  fs::remove(at("shards/00000/000002/sequence.json"));
  fs::remove(at("plan/00001.jsonl"));
  EXPECT_EQ(told(), (Lines{"missing: plan/00001.jsonl",
                           "missing: shards/00000/000000/events.csv.truth/depth/times.csv",
                           "missing: shards/00000/000001", "missing: shards/00000/000002/sequence.json"}));
}

TEST_F(VerifyTest, NamesEachForeignFile) {
  for (const char* name :
       {"notes.txt", "plan/7.jsonl", "plan/00002.jsonl", "shards/00000/000003/a", "shards/00001/000000/a",
        "shards/00000/x", "shards/00000/000000/b", "shards/00000/000001/c/d", "shards/00002/e",
        "failed/00009/f", "failed/00000/000004.json"}) {
    putText(at(name), "");
  }
  Lines found = told();
  std::ranges::sort(found);
  EXPECT_EQ(found,
            (Lines{"foreign: failed/00000/000004.json", "foreign: failed/00009", "foreign: notes.txt",
                   "foreign: plan/00002.jsonl", "foreign: plan/7.jsonl", "foreign: shards/00000/000000/b",
                   "foreign: shards/00000/000001/c", "foreign: shards/00000/000003",
                   "foreign: shards/00000/x", "foreign: shards/00001/000000", "foreign: shards/00002"}));
}

TEST_F(VerifyTest, ASymbolicLinkIsNoFile) {
  const fs::path file = at("shards/00000/000001/events.csv");
  fs::rename(file, scratch_.at("elsewhere.csv"));
  fs::create_symlink(scratch_.at("elsewhere.csv"), file);
  fs::create_symlink("gone", at("shards/00000/000002/more"));
  EXPECT_EQ(told(), (Lines{"damaged: shards/00000/000001/events.csv is not a plain file",
                           "foreign: shards/00000/000002/more"}));
}

TEST_F(VerifyTest, AFolderThatCannotBeReadHindersNoOther) {
  for (const char* name : {"shards/00000/000001", "failed/00001"}) {
    fs::remove_all(at(name));
    fs::create_directories(at(name).parent_path());
    fs::create_symlink(at(name), at(name));  // a link to itself
  }
  fs::rename(at("shards/00000/000002"), scratch_.at("elsewhere"));
  fs::create_directory_symlink(scratch_.at("elsewhere"), at("shards/00000/000002"));
  EXPECT_EQ(told(), (Lines{"damaged: shards/00000/000001 cannot be read: Too many levels of symbolic links",
                           "damaged: shards/00000/000002 is a symbolic link"}));
  EXPECT_EQ(found_.sequences, kSmallSequences - 2);
}

TEST_F(VerifyTest, AShardMayStandElsewhere) {
  fs::rename(at("shards/00001"), scratch_.at("disk"));
  fs::create_directory_symlink(scratch_.at("disk"), at("shards/00001"));
  EXPECT_EQ(told(), Lines{});
}

TEST_F(VerifyTest, AFolderInPlaceOfAFileIsDamage) {
  fs::remove(at("shards/00000/000001/events.csv"));
  fs::create_directories(at("shards/00000/000001/events.csv"));
  fs::remove(at("shards/00001/index.jsonl"));
  fs::create_directories(at("shards/00001/index.jsonl"));
  EXPECT_EQ(told(), (Lines{"damaged: shards/00000/000001/events.csv is not a plain file",
                           "damaged: shards/00001/index.jsonl is not the list of the sequences"}));
}

TEST_F(VerifyTest, AnIndexListsWhatIsThere) {
  const std::string index = readText(set_.indexFile(0));
  for (const std::string& wrong : {index.substr(index.find('\n') + 1), index + index, std::string("{}\n")}) {
    putText(set_.indexFile(0), wrong);
    EXPECT_EQ(told(), Lines{"damaged: shards/00000/index.jsonl is not the list of the sequences"});
  }
}

TEST_F(VerifyTest, ADescriptionIsThatOfItsSequence) {
  const fs::path file = at("shards/00000/000001/sequence.json");
  const std::string before = readText(file);
  std::string text = before;
  text.replace(text.find("0.2"), 3, "0.9");
  putText(file, text);
  EXPECT_EQ(told(),
            (Lines{"damaged: shards/00000/000001/sequence.json differs from its line of index.jsonl",
                   "damaged: shards/00000/000001/sequence.json is not of this sequence of the plan"}));
  fs::remove(set_.indexFile(0));
  putText(file, before.substr(0, before.find("\"files\"")) + "\"files\":[]}");
  EXPECT_EQ(told(), (Lines{"foreign: shards/00000/000001/events.csv",
                           "foreign: shards/00000/000001/events.csv.truth"}));
}

TEST_F(VerifyTest, ATableIsThatOfItsShard) {
  fs::copy_file(at("plan/00001.jsonl"), at("plan/00000.jsonl"), fs::copy_options::overwrite_existing);
  EXPECT_EQ(told().front(), "damaged: plan/00000.jsonl is not the table of the shard");
}

TEST_F(VerifyTest, ASequenceThatCanNeverBeMadeIsNotMissing) {
  for (const std::uint64_t i : {0, 1}) fs::remove_all(set_.sequenceFolder(smallSequence(i)));
  fs::remove(set_.indexFile(0));
  recordFailure(set_, smallSequence(0), "no such scene", false);
  recordFailure(set_, smallSequence(1), "the disk is full", true);
  EXPECT_EQ(told(), Lines{"missing: shards/00000/000001 (the disk is full)"});
  EXPECT_EQ(found_.failed, 1u);
}

}  // namespace
}  // namespace saccade::farm
