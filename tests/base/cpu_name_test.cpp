#include "base/cpu_name.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace saccade {
namespace {

TEST(CpuName, IsTheLineOfTheSystemWithoutItsLabel) {
  std::ifstream file("/proc/cpuinfo");
  const std::string cores{std::istreambuf_iterator<char>(file), {}};
  if (cores.find("model name") == std::string::npos) {
    EXPECT_EQ(cpuName(), "unknown");
    return;
  }
  EXPECT_FALSE(cpuName().empty());
  EXPECT_EQ(cpuName().find_first_of(":\n\t"), std::string::npos);
  EXPECT_NE(cores.find("model name\t: " + cpuName() + "\n"), std::string::npos) << cpuName();
}

}  // namespace
}  // namespace saccade
