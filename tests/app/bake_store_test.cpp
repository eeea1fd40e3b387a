// Bakes that streams share: one is made for all who ask, and goes on where it was stopped.
#include "app/stores/bake_store.h"

#include <gtest/gtest.h>

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
    return store.get(scene, plan, pool, stop, progress);
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

TEST_F(BakeStoreTest, OneIsMadeForAllWhoAsk) {
  std::promise<void> go_on;
  auto busy = std::async(std::launch::async, [&] {
    const std::shared_future<void> gone_on = go_on.get_future().share();
    PoolHandle(pool).run(2, [&](int) { gone_on.wait(); });
  });
  auto first = std::async(std::launch::async, [&] { return get(); });
  auto second = std::async(std::launch::async, [&] { return get(); });
  std::stop_source stopped;
  auto leaving = std::async(std::launch::async, [&] { return get(stopped.get_token()); });
  stopped.request_stop();
  EXPECT_THROW(leaving.get(), Cancelled);
  go_on.set_value();
  EXPECT_EQ(first.get(), second.get());
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
