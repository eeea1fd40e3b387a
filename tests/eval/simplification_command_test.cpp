// `saccade-eval simplification` as a user runs it, on very small pictures.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "scene/scratch.h"
#include "tables/simplification_table.h"

namespace saccade {
namespace {

struct SimplificationCommand : testing::Test {
  Scratch files;
  const std::string table = files.path("simplification.csv");

  // Returns the exit code. The output goes to `log`.
  int simplification(const std::string& arguments) {
    const std::string command =
        std::string(SACCADE_EVAL) + " simplification " + arguments +
        " --size 16x12 --frames 1 --bounces 1 --method pt --spp 1 --reference 64 --cache " +
        files.path("cache") + " -o " + table + " > " + files.path("log") + " 2>&1";
    return WEXITSTATUS(std::system(command.c_str()));
  }
  std::string log() const {
    std::ostringstream text;
    text << std::ifstream(files.path("log")).rdbuf();
    return text.str();
  }
};

TEST_F(SimplificationCommand, SaysWhatEachPartIsWorthAndKeepsIt) {
  ASSERT_EQ(simplification("textured-cornell-box --tolerance 100%"), 0) << log();
  expectContains(log(), "textured-cornell-box: 32 triangles");
  expectContains(log(), "\n  0 bounces ");
  expectContains(log(), "\n  without textures ");
  expectContains(log(), "\n  without mip_filtering ");
  expectContains(log(), "\n  within 100%: ");
  ASSERT_EQ(simplification("cornell-box"), 0) << log();
  const SimplificationTable kept = readSimplificationTable(table);
  EXPECT_EQ(kept.scenes(), (std::vector<std::string>{"cornell-box", "textured-cornell-box"}));
  EXPECT_EQ(kept.modelsOf("cornell-box").size(), 2u);
  EXPECT_GE(kept.modelsOf("textured-cornell-box").size(), 4u);
}

TEST_F(SimplificationCommand, RefusesATableOfOtherSettings) {
  ASSERT_EQ(simplification("cornell-box"), 0) << log();
  EXPECT_EQ(simplification("cornell-box --threshold 0.3"), 1);
  expectContains(log(), "simplification.csv was made with other settings");
}

}  // namespace
}  // namespace saccade
