#include "client/options/output_options.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "scratch_folder.h"

namespace saccade::client {
namespace {

class OutputOptionsTest : public testing::Test {
 protected:
  std::string faultOf(const std::string& output, int sensors = 1, bool force = false) const {
    try {
      checkOutputs({.path = output, .force = force}, sensors);
    } catch (const std::invalid_argument& fault) {
      return fault.what();
    }
    return {};
  }
  std::string touch(const std::string& name) const {
    std::ofstream(folder_.at(name)) << "kept\n";
    return folder_.at(name);
  }
  const ScratchFolder folder_;
};

TEST_F(OutputOptionsTest, ANewFileIsRight) {
  EXPECT_EQ(faultOf(folder_.at("a.csv")), "");
  EXPECT_EQ(faultOf("-"), "");
}

// Each format with the extension of each: only those of one row of the table belong together.
TEST_F(OutputOptionsTest, AFormatFitsItsExtensionAlone) {
  const auto faultOf = [](const std::string& path, const std::string& format) {
    try {
      writerFor(path, format);
    } catch (const std::invalid_argument& fault) {
      return std::string(fault.what());
    }
    return std::string();
  };
  for (const WriterInfo* format : writerTable()) {
    for (const WriterInfo* other : writerTable()) {
      const std::string path = std::string("a") + other->extension, fault = faultOf(path, format->name);
      const bool fits = std::string(format->extension) == other->extension;
      EXPECT_EQ(fault.empty(), fits) << fault;
      if (fits) continue;
      for (const std::string& word : {std::string(format->name), path, std::string(other->name)})
        EXPECT_NE(fault.find(word), std::string::npos) << word << " is not in: " << fault;
    }
  }
  EXPECT_EQ(faultOf("a.csv", "evt3"), "--format: evt3 makes .raw files, and 'a.csv' is for csv");
  EXPECT_NE(faultOf("a.dat", "csv").find("'a.dat' has no known extension"), std::string::npos);
  EXPECT_NE(faultOf("a", "csv").find("'a' has no known extension"), std::string::npos);
}

TEST_F(OutputOptionsTest, AFileThatExistsIsReplacedOnlyByForce) {
  const std::string file = touch("a.csv"), second = touch("b-1.csv");
  EXPECT_EQ(faultOf(file), "--output: '" + file + "' exists; --force replaces it");
  EXPECT_EQ(faultOf(file, 1, true), "");
  EXPECT_EQ(faultOf(folder_.at("b.csv"), 2), "--output: '" + second + "' exists; --force replaces it");
  EXPECT_EQ(faultOf(folder_.at("b.csv"), 1), "");
}

TEST_F(OutputOptionsTest, SensorsOfOneFileHaveDescriptionsOfTheirOwn) {
  const std::string json = touch("b.bag.sensor1.json");
  touch("b-1.bag");
  EXPECT_EQ(faultOf(folder_.at("b.bag"), 2), "--output: '" + json + "' exists; --force replaces it");
  EXPECT_EQ(faultOf(folder_.at("b.bag"), 1), "");
}

TEST_F(OutputOptionsTest, OnlyARegularFileIsReplaced) {
  const std::string folder = folder_.at("a.csv"), pipe = folder_.at("b.csv");
  std::filesystem::create_directory(folder);
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(faultOf(folder, 1, true), "--output: '" + folder + "' is a folder");
  EXPECT_NE(faultOf(pipe, 1, true).find("is not a regular file; -o - writes to a pipe"), std::string::npos);
}

TEST_F(OutputOptionsTest, TheFolderMustBeThere) {
  EXPECT_NE(faultOf(folder_.at("none/a.csv")).find("there is no folder"), std::string::npos);
}

TEST_F(OutputOptionsTest, StandardOutputHasOneSensor) {
  EXPECT_NE(faultOf("-", 2).find("one sensor"), std::string::npos);
}

TEST_F(OutputOptionsTest, TheJsonOfAFileIsCheckedToo) {
  const std::string json = touch("a.csv.json");
  EXPECT_EQ(faultOf(folder_.at("a.csv")), "--output: '" + json + "' exists; --force replaces it");
}

}  // namespace
}  // namespace saccade::client
