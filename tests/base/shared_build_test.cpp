// Values that are built once for all who wait for them.
#include "base/shared_build.h"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <stdexcept>

namespace saccade {
namespace {

using Builds = SharedBuild<int, int>;
using Result = Builds::Result;

struct SharedBuildTest : testing::Test {
  // A build that waits for `go_on`, heedless of its stop.
  Result built(const BuildContext&) {
    ++begun;
    begun.notify_all();
    gone_on.wait();
    return std::make_shared<const int>(++values);
  }
  std::future<Result> ask(int key, const std::stop_token& stop = {}) {
    return std::async(std::launch::async, [=, this] {
      return builds.get(key, stop, [this](const BuildContext& context) { return built(context); });
    });
  }
  void awaitBegun(int count) {
    for (int now = begun; now < count; now = begun) begun.wait(now);
  }

  std::promise<void> go_on;
  std::shared_future<void> gone_on = go_on.get_future().share();
  std::atomic<int> begun = 0, values = 0;
  Builds builds;  // its threads use the others
};

TEST_F(SharedBuildTest, AllWhoAskGetTheSame) {
  auto first = ask(1);
  awaitBegun(1);
  auto second = ask(1), other = ask(2);
  awaitBegun(2);
  go_on.set_value();
  const Result value = first.get();
  EXPECT_NE(other.get(), value);
  const Result late = second.get();  // which may have asked when the first was done
  EXPECT_EQ(begun, late == value ? 2 : 3);
}

TEST_F(SharedBuildTest, OneWhoLeavesDoesNotWait) {
  auto stays = ask(1);
  awaitBegun(1);
  std::stop_source stopped;
  auto leaves = ask(1, stopped.get_token());
  stopped.request_stop();
  EXPECT_THROW(leaves.get(), Cancelled);
  go_on.set_value();
  EXPECT_EQ(*stays.get(), 1);
}

TEST_F(SharedBuildTest, TheLastWhoLeavesStopsTheBuildAndTheNextBuildsAnew) {
  std::stop_source stopped;
  std::promise<void> asked_to_stop;
  const auto obedient = [&](const BuildContext& context) -> Result {
    const std::stop_callback told(context.stop, [&] { asked_to_stop.set_value(); });
    stopped.request_stop();
    gone_on.wait();
    throw Cancelled();
  };
  EXPECT_THROW(builds.get(1, stopped.get_token(), obedient), Cancelled);
  asked_to_stop.get_future().wait();
  auto next = ask(1);  // waits for the end of the first
  EXPECT_EQ(begun, 0);
  go_on.set_value();
  EXPECT_EQ(*next.get(), 1);
}

TEST_F(SharedBuildTest, AFaultIsToldAndTheNextTriesAgain) {
  const auto fails = [](const BuildContext&) -> Result { throw std::invalid_argument("no"); };
  EXPECT_THROW(builds.get(1, {}, fails), std::invalid_argument);
  EXPECT_EQ(*builds.get(1, {}, [](const BuildContext&) { return std::make_shared<const int>(7); }), 7);
}

TEST_F(SharedBuildTest, TheResultIsHeldByNobodyElse) {
  const auto build = [](const BuildContext&) { return std::make_shared<const int>(7); };
  EXPECT_EQ(builds.get(1, {}, build).use_count(), 1);
}

TEST_F(SharedBuildTest, ProgressIsToldToItsEnd) {
  double last = 0;
  const auto build = [](const BuildContext& context) {
    for (const double share : {0.25, 0.5, 1.0}) context.setProgress(share);
    return std::make_shared<const int>(7);
  };
  builds.get(1, {}, build, [&](double share) {
    EXPECT_GT(share, last);
    last = share;
  });
  EXPECT_EQ(last, 1);
}

TEST_F(SharedBuildTest, BuildsAtOnceAreBounded) {
  std::vector<std::future<Result>> all;
  const int most = Builds::kMostBuilds;
  for (int key = 0; key < most; ++key) all.push_back(ask(key));
  awaitBegun(most);
  std::stop_source stopped;
  auto leaves = ask(most, stopped.get_token());
  all.push_back(ask(most + 1));
  stopped.request_stop();
  EXPECT_THROW(leaves.get(), Cancelled);
  EXPECT_EQ(begun, most);
  go_on.set_value();
  for (auto& one : all) EXPECT_NE(one.get(), nullptr);
  EXPECT_EQ(begun, most + 1);
}

}  // namespace
}  // namespace saccade
