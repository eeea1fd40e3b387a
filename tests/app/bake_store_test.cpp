// Who makes a bake, who waits for it, and who stops.
#include "app/streams/bake_store.h"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <future>

#include "render/test_scenes.h"

namespace saccade {
namespace {

struct BakeStoreTest : testing::Test {
  BakeStoreTest() {
    std::filesystem::remove_all(folder);
    plan.poses = {Pose{{0, 0, -0.9}, {}}};
    plan.camera = pinhole(80, 12, 12);
  }
  std::shared_ptr<const Bake> get(
      const std::stop_token& stop = {}, const std::function<void(double)>& progress = [](double) {}) {
    return store.get(scene, plan, PoolHandle(pool, Priority::kNormal, stop), stop, progress);
  }

  const std::string folder =
      testing::TempDir() + "saccade-" + testing::UnitTest::GetInstance()->current_test_info()->name();
  const std::shared_ptr<const RenderScene> scene = std::make_shared<RenderScene>(test::furnace(0.6f, 1));
  BakePlan plan;
  TilePool pool{2};
  BakeStore store{folder, Limits()};
};

TEST_F(BakeStoreTest, TellsItsProgress) {
  double last = 0;
  get({}, [&](double share) {
    EXPECT_GE(share, last);
    last = share;
  });
  EXPECT_EQ(last, 1);
}

TEST_F(BakeStoreTest, OneMakesItAndTheOthersWait) {
  std::promise<void> go_on;
  std::promise<void> begun;
  std::atomic<int> passes = 0;
  const auto count = [&](double) {
    if (++passes == 1) begun.set_value(), go_on.get_future().wait();
  };
  auto maker = std::async(std::launch::async, [&] { return get({}, count); });
  begun.get_future().wait();
  auto waiting = std::async(std::launch::async,
                            [&] { return get({}, [](double) { ADD_FAILURE() << "it is made twice"; }); });
  std::stop_source stopped;
  auto leaving = std::async(std::launch::async, [&] { return get(stopped.get_token()); });
  stopped.request_stop();
  EXPECT_THROW(leaving.get(), Cancelled);
  EXPECT_EQ(waiting.wait_for(std::chrono::milliseconds(20)), std::future_status::timeout);
  go_on.set_value();
  EXPECT_EQ(maker.get(), waiting.get());
}

TEST_F(BakeStoreTest, AnotherGoesOnWhereTheMakerStops) {
  std::stop_source stopped;
  EXPECT_THROW(get(stopped.get_token(), [&](double) { stopped.request_stop(); }), Cancelled);
  const auto bake = get();
  ASSERT_TRUE(bake);
  EXPECT_GT(bake->light->vertices(), 0u);
}

}  // namespace
}  // namespace saccade
