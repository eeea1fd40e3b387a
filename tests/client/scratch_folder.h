// A folder of its own for each test, gone afterwards: ctest runs the tests of a program as processes at once.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

namespace saccade {

class ScratchFolder {
 public:
  ScratchFolder() { std::filesystem::create_directories(folder_); }
  ~ScratchFolder() { std::filesystem::remove_all(folder_); }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::string at(const std::string& name) const { return folder_ / name; }

 private:
  const std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) /
      (std::string("saccade-") + testing::UnitTest::GetInstance()->current_test_info()->name() + "-" +
       std::to_string(getpid()));
};

}  // namespace saccade
