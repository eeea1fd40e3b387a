#include "farm/worker/crew.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>

namespace saccade::farm {
namespace {

constexpr int kWaitMs = 10;

// All outcomes of the numbers below `count`.
std::map<std::uint64_t, Outcome> runAll(Crew& crew, std::uint64_t count) {
  std::map<std::uint64_t, Outcome> outcomes;
  const auto await = [&] {
    if (const auto outcome = crew.next(kWaitMs)) outcomes.emplace(outcome->number, *outcome);
  };
  for (std::uint64_t i = 0; i < count; ++i) {
    while (!crew.isIdle()) await();
    crew.give(i);
  }
  while (crew.busy() > 0) await();
  return outcomes;
}

pid_t onlyChild() {
  std::ifstream children("/proc/self/task/" + std::to_string(getpid()) + "/children");
  pid_t child = -1;
  children >> child;
  return child;
}

TEST(Crew, GivesEachTaskToAWorker) {
  Crew crew(3,
            [](int) { return [](std::uint64_t number) { return number % 2 ? Made::kNever : Made::kDone; }; });
  const auto outcomes = runAll(crew, 20);
  ASSERT_EQ(outcomes.size(), 20u);
  for (const auto& [number, outcome] : outcomes)
    EXPECT_EQ(outcome.made, number % 2 ? Made::kNever : Made::kDone);
}

TEST(Crew, AWorkerThatDiesTakesOneTaskWithIt) {
  Crew crew(2, [](int) {
    return [](std::uint64_t number) {
      if (number % 5 == 3) kill(getpid(), SIGKILL);
      if (number == 7) _exit(9);
      return Made::kDone;
    };
  });
  const auto outcomes = runAll(crew, 20);
  ASSERT_EQ(outcomes.size(), 20u);
  for (const auto& [number, outcome] : outcomes) {
    const bool dies = number % 5 == 3 || number == 7;
    EXPECT_EQ(outcome.made, dies ? Made::kRetry : Made::kDone) << number;
    EXPECT_EQ(outcome.death.empty(), !dies) << number;
  }
  EXPECT_EQ(outcomes.at(3).death, "the worker was ended by signal 9 (Killed)");
  EXPECT_EQ(outcomes.at(7).death, "the worker ended with status 9");
}

TEST(Crew, ATaskForADeadWorkerHarmsNobodyElse) {
  Crew crew(1, [](int) { return [](std::uint64_t) { return Made::kDone; }; });
  const pid_t worker = onlyChild();
  kill(worker, SIGKILL);
  siginfo_t died{};
  ASSERT_EQ(waitid(P_PID, static_cast<id_t>(worker), &died, WEXITED | WNOWAIT), 0);
  crew.give(1);
  std::optional<Outcome> outcome;
  while (!outcome) outcome = crew.next(kWaitMs);
  EXPECT_EQ(outcome->number, 1u);
  EXPECT_EQ(outcome->death, "the worker was ended by signal 9 (Killed)");
}

TEST(Crew, SaysThatNoWorkerCanBegin) {
  Crew crew(1, [](int) -> Crew::Work { throw std::runtime_error("no"); });
  crew.give(0);
  EXPECT_THROW(
      {
        while (crew.busy() > 0) crew.next(kWaitMs);
      },
      std::runtime_error);
}

TEST(Crew, EndsItsWorkersAtOnce) {
  Crew crew(2, [](int) {
    return [](std::uint64_t) {
      for (;;) pause();
      return Made::kDone;
    };
  });
  crew.give(0);
  crew.give(1);
  crew.stop();
  EXPECT_EQ(crew.busy(), 0u);
}

}  // namespace
}  // namespace saccade::farm
