#include "feed/bake_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "feed/temporary_file.h"

namespace saccade {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMost = 1000;  // bytes

struct BakeFile : testing::Test {
  BakeFile() { fs::remove_all(folder); }
  // The fault of reading, which must name the file.
  std::string fault(std::uint64_t plan = 7) const {
    try {
      readBake(path, plan, kMost);
    } catch (const std::runtime_error& e) {
      EXPECT_TRUE(std::string(e.what()).starts_with(path)) << e.what();
      return std::string(e.what()).substr(path.size() + 2);
    }
    return "none";
  }
  void change(std::size_t at) const {
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekg(static_cast<std::streamoff>(at));
    const auto byte = static_cast<char>(file.get() ^ 1);
    file.seekp(static_cast<std::streamoff>(at));
    file.put(byte);
  }

  const std::string folder =
      testing::TempDir() + "saccade-" + testing::UnitTest::GetInstance()->current_test_info()->name();
  const std::string path = bakePath(folder, 0x0123456789abcdef);
};

TEST_F(BakeFile, ReturnsWhatWasWritten) {
  EXPECT_EQ(fs::path(path).filename(), "0123456789abcdef.bake");
  EXPECT_FALSE(readBake(path, 7, kMost));
  const std::uint64_t first = writeBake(path, 7, "first"), second = writeBake(path, 7, "the second");
  EXPECT_NE(first, second);
  const auto kept = readBake(path, 7, kMost);
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->state, "the second");
  EXPECT_EQ(kept->digest, second);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1);
}

TEST_F(BakeFile, EachChangedByteIsFound) {
  for (std::size_t at = 0; at < 32 + 5; ++at) {
    writeBake(path, 7, "state");
    change(at);
    EXPECT_NE(fault(), "none") << at;
  }
}

TEST_F(BakeFile, SaysWhatIsWrong) {
  writeBake(path, 7, "state");
  EXPECT_EQ(fault(8), "is the bake of something else");
  change(34);
  EXPECT_EQ(fault(), "is damaged");
  fs::resize_file(path, 36);
  EXPECT_EQ(fault(), "is damaged: its size is wrong");
  fs::resize_file(path, 12);
  EXPECT_EQ(fault(), "is not a bake of this version");
}

TEST_F(BakeFile, WhatIsNoFileIsNotOpened) {
  fs::create_directories(path);
  EXPECT_EQ(fault(), "is not a file");
  fs::remove(path);
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);  // to open it would wait
  EXPECT_EQ(fault(), "is not a file");
  fs::remove(path);
  fs::create_symlink(path, path);
  EXPECT_EQ(fault(), "is not a file");
  fs::remove(path);
  fs::create_symlink(path + ".nothing", path);
  EXPECT_FALSE(readBake(path, 7, kMost));
  writeBake(path, 7, "state");
  EXPECT_EQ(readBake(path, 7, kMost)->state, "state");
}

// A sparse file of 4 EiB would end a program that makes room for it.
TEST_F(BakeFile, ALargerOneThanThePlanCanHaveIsNotRead) {
  writeBake(path, 7, "state");
  constexpr std::uint64_t kSize = std::uint64_t{1} << 40;
  {
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(16);
    file.write(reinterpret_cast<const char*>(&kSize), sizeof kSize);
  }
  fs::resize_file(path, kSize + 32);
  EXPECT_EQ(fault(), "has more than 1000 bytes");
}

TEST_F(BakeFile, OneThatIsSetAsideMakesRoom) {
  writeBake(path, 7, "first");
  EXPECT_EQ(setBakeAside(path), path + ".damaged");
  EXPECT_FALSE(readBake(path, 7, kMost));
  fs::create_directory(path);
  setBakeAside(path);  // in the place of the first
  EXPECT_TRUE(fs::is_directory(path + ".damaged"));
}

TEST_F(BakeFile, WhatKilledProgramsHaveLeftIsRemoved) {
  writeBake(path, 7, "state");
  TemporaryFile under_way(path);
  under_way.write("half", 4);
  for (const std::string letters : {".123", ".aBcDeF", ".damaged"}) std::ofstream(path + letters) << "left";
  std::ofstream(folder + "/another") << "file";
  const std::vector<std::string> all = bakeFiles(folder);
  EXPECT_EQ(all.size(), 3u);  // the bake, the one under way and the damaged one
  EXPECT_FALSE(fs::exists(path + ".123"));
  EXPECT_FALSE(fs::exists(path + ".aBcDeF"));
  EXPECT_TRUE(fs::exists(path + ".damaged"));
  EXPECT_TRUE(fs::exists(folder + "/another"));
  under_way.keep();
  EXPECT_EQ(fs::file_size(path), 4u);
}

TEST_F(BakeFile, SaysThatItCannotBeWritten) {
  std::ofstream(folder) << "no folder";
  EXPECT_THROW(writeBake(path, 7, "state"), std::runtime_error);
}

}  // namespace
}  // namespace saccade
