#include "feed/bake_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace saccade {
namespace {

namespace fs = std::filesystem;

struct BakeFile : testing::Test {
  BakeFile() { fs::remove_all(folder); }
  // The fault of reading, which must name the file.
  std::string fault(std::uint64_t plan = 7) const {
    try {
      readBake(path, plan);
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
  EXPECT_FALSE(readBake(path, 7));
  const std::uint64_t first = writeBake(path, 7, "first"), second = writeBake(path, 7, "the second");
  EXPECT_NE(first, second);
  const auto kept = readBake(path, 7);
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
  EXPECT_EQ(fault(8), "is the bake of something else; remove it");
  change(34);
  EXPECT_EQ(fault(), "is damaged; remove it");
  fs::resize_file(path, 36);
  EXPECT_EQ(fault(), "is damaged: its size is wrong; remove it");
  fs::resize_file(path, 12);
  EXPECT_EQ(fault(), "is not a bake of this version; remove it");
  fs::remove(path);
  fs::create_directory(path);
  EXPECT_NE(fault(), "none");
}

TEST_F(BakeFile, SaysThatItCannotBeWritten) {
  std::ofstream(folder) << "no folder";
  EXPECT_THROW(writeBake(path, 7, "state"), std::runtime_error);
}

}  // namespace
}  // namespace saccade
