#include "farm/pack/pack.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "client/scratch_folder.h"
#include "farm/pack/members.h"
#include "farm/pack/tar_writer.h"
#include "farm/small_data_set.h"

namespace saccade::farm {
namespace {

namespace fs = std::filesystem;

bool never() {
  return false;
}

class PackTest : public testing::Test {
 protected:
  PackCounts packed() {
    return pack(
        set_, never, [&](const std::string& fault) { faults_.push_back(fault); }, [](const PackCounts&) {});
  }
  fs::path at(const std::string& name) const { return set_.folder() / name; }

  ScratchFolder scratch_;
  const DataSet set_ = makeSmallDataSet(scratch_.at("set"));
  std::vector<std::string> faults_;
};

TEST(TarHeader, HasTheFieldsOfUstar) {
  const std::string block = tarHeader("000001.events.h5", 1234);
  ASSERT_EQ(block.size(), 512u);
  EXPECT_STREQ(block.data(), "000001.events.h5");
  EXPECT_STREQ(block.data() + 100, "0000644");      // mode
  EXPECT_STREQ(block.data() + 108, "0000000");      // user
  EXPECT_STREQ(block.data() + 124, "00000002322");  // size: 1234 in octal
  EXPECT_STREQ(block.data() + 136, "00000000000");  // time
  EXPECT_EQ(block[156], '0');
  EXPECT_EQ(block.substr(257, 8), std::string("ustar\0"
                                              "00",
                                              8));
  int sum = 8 * ' ';
  for (std::size_t i = 0; i < block.size(); ++i)
    if (i < 148 || i >= 156) sum += static_cast<unsigned char>(block[i]);
  EXPECT_EQ(std::stoi(block.substr(148, 6), nullptr, 8), sum);
}

TEST(TarHeader, HasAnotherHeaderForLongNamesAndHugeFiles) {
  const std::string name(101, 'n');
  EXPECT_EQ(tarHeader(std::string(100, 'n'), 1).size(), 512u);
  const std::string long_name = tarHeader(name, 1);
  ASSERT_EQ(long_name.size(), 3 * 512u);
  EXPECT_EQ(long_name[156], 'x');
  EXPECT_STREQ(long_name.data() + 512, ("111 path=" + name + "\n").c_str());
  const std::string huge = tarHeader("a", std::uint64_t{1} << 33);
  EXPECT_STREQ(huge.data() + 512, "19 size=8589934592\n");
}

TEST_F(PackTest, MembersAreNamedByTheirSequence) {
  v1::DataSetSequence sequence = smallSequence(3);
  sequence.add_files()->set_name("events.raw.truth/depth/000012.exr");
  sequence.add_files()->set_name("events.raw");
  const std::vector<Member> members = membersOf(set_, sequence, 10);
  ASSERT_EQ(members.size(), 3u);
  EXPECT_EQ(members[0].name, "000003.events.raw");
  EXPECT_EQ(members[1].name, "000003.events.raw.truth.depth.000012.exr");
  EXPECT_EQ(members[2].name, "000003.sequence.json");
}

TEST_F(PackTest, RefusesNamesThatCannotBe) {
  for (const std::string name : {"../a", "/etc/a", "a/../../b", ""}) {
    v1::DataSetSequence sequence = smallSequence(3);
    sequence.add_files()->set_name(name);
    EXPECT_THROW(membersOf(set_, sequence, 10), std::runtime_error) << name;
  }
  v1::DataSetSequence sequence = smallSequence(3);
  for (const char* name : {"a/b", "a.b"}) sequence.add_files()->set_name(name);
  EXPECT_THROW(membersOf(set_, sequence, 10), std::runtime_error);
}

TEST_F(PackTest, WritesATarOfEachSplitAndShard) {
  const PackCounts counts = packed();
  EXPECT_EQ(counts.written, 4u);
  EXPECT_EQ(counts.sequences, kSmallSequences);
  std::uint64_t bytes = 0;
  for (const char* name : {"train-00000.tar", "test-00000.tar", "train-00001.tar", "test-00001.tar"})
    bytes += fs::file_size(at("webdataset") / name);
  EXPECT_EQ(counts.bytes, bytes);
  const std::string tar = readText(at("webdataset/test-00000.tar"));
  EXPECT_STREQ(tar.data(), "000002.events.csv");
  EXPECT_EQ(tar.substr(512, smallCsv(2).size()), smallCsv(2));
}

TEST_F(PackTest, ASplitThatAShardLacksHasAnEmptyTar) {
  const std::string index = readText(set_.indexFile(1));
  putText(set_.indexFile(1), index.substr(0, index.find('\n') + 1));  // a sequence of train
  EXPECT_EQ(packed().written, 4u);
  EXPECT_EQ(readText(at("webdataset/test-00001.tar")), std::string(kTarEnd, '\0'));
}

TEST_F(PackTest, WhatIsThereIsNotWrittenAgain) {
  packed();
  const std::string before = readText(at("webdataset/test-00000.tar"));
  fs::remove(at("webdataset/test-00000.tar"));
  fs::resize_file(at("webdataset/train-00001.tar"), 512);
  const PackCounts counts = packed();
  EXPECT_EQ(counts.found, 2u);
  EXPECT_EQ(counts.written, 2u);
  EXPECT_EQ(readText(at("webdataset/test-00000.tar")), before);
}

TEST_F(PackTest, ADamagedFileIsNamedAndItsShardLeftOut) {
  std::string csv = smallCsv(1);
  csv.back() = ' ';
  for (const std::string& wrong : {csv, smallCsv(1) + "1", std::string()}) {
    putText(at("shards/00000/000001/events.csv"), wrong);
    faults_.clear();
    EXPECT_EQ(packed().faulty, 1u);
    ASSERT_EQ(faults_.size(), 1u);
    EXPECT_NE(faults_[0].find("shards/00000/000001/events.csv"), std::string::npos) << faults_[0];
    EXPECT_FALSE(fs::exists(at("webdataset/train-00000.tar")));
    EXPECT_FALSE(fs::exists(at("webdataset/test-00000.tar")));
    EXPECT_TRUE(fs::exists(at("webdataset/test-00001.tar")));
  }
  for (const auto& entry : fs::directory_iterator(at("webdataset")))
    EXPECT_EQ(entry.path().extension(), ".tar") << entry.path();
}

TEST_F(PackTest, AnUnfinishedShardIsLeftOut) {
  fs::remove(set_.indexFile(1));
  const PackCounts counts = packed();
  EXPECT_EQ(counts.unfinished, 1u);
  EXPECT_EQ(counts.written, 2u);
}

TEST_F(PackTest, StopsWithoutLeavingAPart) {
  const PackCounts counts = pack(
      set_, [] { return true; }, [](const std::string&) {}, [](const PackCounts&) {});
  EXPECT_TRUE(counts.stopped);
  EXPECT_EQ(counts.written, 0u);
  EXPECT_TRUE(fs::is_empty(at("webdataset")));
}

}  // namespace
}  // namespace saccade::farm
