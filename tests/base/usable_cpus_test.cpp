#include "base/usable_cpus.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace saccade {
namespace {

namespace fs = std::filesystem;

class CgroupQuota : public testing::Test {
 protected:
  ~CgroupQuota() override { fs::remove_all(root_); }
  void write(const std::string& file, const std::string& text) {
    fs::create_directories((root_ + "/" + file).substr(0, (root_ + "/" + file).find_last_of('/')));
    std::ofstream(root_ + "/" + file) << text;
  }
  const std::string root_ = testing::TempDir() + "cgroup_quota_test." + std::to_string(getpid());
};

TEST_F(CgroupQuota, IsTheLeastOfAGroupAndItsParents) {
  EXPECT_TRUE(std::isinf(cgroupQuota("0::/a/b\n", root_)));
  write("a/b/cpu.max", "max 100000\n");
  EXPECT_TRUE(std::isinf(cgroupQuota("0::/a/b\n", root_)));
  write("a/cpu.max", "150000 100000\n");
  EXPECT_EQ(cgroupQuota("0::/a/b\n", root_), 1.5);
  write("a/b/cpu.max", "40000 20000\n");
  EXPECT_EQ(cgroupQuota("0::/a/b\n", root_), 1.5);
  EXPECT_EQ(cgroupQuota("0::/other\n", root_), INFINITY);
  write("cpu.max", "50000 100000\n");  // of a container that sees itself as the root
  EXPECT_EQ(cgroupQuota("0::/\n", root_), 0.5);
}

TEST_F(CgroupQuota, OfVersion1) {
  write("cpu,cpuacct/a/cpu.cfs_quota_us", "-1\n");
  write("cpu,cpuacct/a/cpu.cfs_period_us", "100000\n");
  write("memory/a/cpu.cfs_quota_us", "1000\n");
  const std::string groups = "5:memory:/a\n4:cpu,cpuacct:/a\nrubbish\n0::/\n";
  EXPECT_TRUE(std::isinf(cgroupQuota(groups, root_)));
  write("cpu,cpuacct/a/cpu.cfs_quota_us", "250000\n");
  EXPECT_EQ(cgroupQuota(groups, root_), 2.5);
}

TEST(UsableCpus, IsSomething) {
  EXPECT_GT(usableCpus(), 0);
  EXPECT_FALSE(std::isinf(usableCpus()));
}

}  // namespace
}  // namespace saccade
