#include <gtest/gtest.h>

#include <stdexcept>

#include "engines/planned_set.h"
#include "farm/engines/slurm.h"

namespace saccade::farm {
namespace {

bool has(const std::string& text, const std::string& line) {
  return ("\n" + text).find("\n" + line + "\n") != std::string::npos;
}

TEST(SlurmScript, AsksForWhatTheOptionsSay) {
  const PlannedSet planned(20);
  const std::string text = slurmScript(
      planned.set(),
      {.engine = {.program = "/bin/farm", .cpus = 3, .memory_mib = 500, .parallel = 7}, .time = "1-2:30"});
  for (const char* line : {"#SBATCH --job-name=indoor", "#SBATCH --array=0-19%7", "#SBATCH --cpus-per-task=3",
                           "#SBATCH --mem=500M", "#SBATCH --time=1-2:30", "#SBATCH --signal=B:USR1@60",
                           "#SBATCH --requeue", "program='/bin/farm'", "shards=20 tasks=20 most_restarts=3"})
    EXPECT_TRUE(has(text, line)) << line << "\n" << text;
}

TEST(SlurmScript, HasNoLimitsThatNobodyAskedFor) {
  const std::string text = slurmScript(PlannedSet(1).set(), {});
  EXPECT_TRUE(has(text, "#SBATCH --array=0-0"));
  EXPECT_EQ(text.find("--time"), text.npos);
}

TEST(SlurmScript, SharesShardsAmongFewerTasks) {
  const PlannedSet planned(5000);
  EXPECT_EQ(slurmTasks(planned.set(), {}), 5000u);
  EXPECT_EQ(slurmTasks(planned.set(), {.tasks = 9000}), 5000u);
  const std::string text = slurmScript(planned.set(), {.tasks = 1000});
  EXPECT_TRUE(has(text, "#SBATCH --array=0-999")) << text;
  EXPECT_TRUE(has(text, "shards=5000 tasks=1000 most_restarts=3")) << text;
}

TEST(SlurmScript, PutsNoFolderBeforeTheFirstCommand) {
  const PlannedSet planned(2, "a'b\n#SBATCH --wrap=x; $(y)");
  const std::string text = slurmScript(planned.set(), {});
  const std::size_t first = text.find("\nset -u\n");
  ASSERT_NE(first, text.npos);
  EXPECT_GT(text.find("--wrap=x"), first);
  EXPECT_NE(text.find("a'\\''b\n"), text.npos) << text;
}

TEST(SlurmScript, TakesNoTimeThatSlurmDoesNotKnow) {
  const PlannedSet planned(2);
  for (const char* time : {"30", "1:30", "1:30:00", "2-12", "2-12:30:00"})
    EXPECT_NO_THROW(slurmScript(planned.set(), {.time = time})) << time;
  for (const char* time : {"x", "1h", "1:2:3:4", "-1", "5\n#SBATCH --wrap=x"})
    EXPECT_THROW(slurmScript(planned.set(), {.time = time}), std::invalid_argument) << time;
}

}  // namespace
}  // namespace saccade::farm
