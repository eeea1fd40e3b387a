#include "eval/bench/time_bench.h"

#include <gtest/gtest.h>

#include "eval/bench/open_scene.h"

namespace saccade::eval {
namespace {

// The cache finds out in the first frames what it will know later. Times of so few pixels are rough.
TEST(TimeBench, FindsThatLateFramesOfACacheAreCheaper) {
  TilePool pool(2);
  BenchSetup setup;
  setup.width = 64, setup.height = 48, setup.first = setup.last = 10, setup.reference_spp = 0;
  const auto scene = openScene(setup.scene);
  const MeasuredTime time = TimeBench(setup, scene, pool).run(parseMethod("irradiance_cache"), 8);
  EXPECT_GT(time.small_late_ms, 0);
  EXPECT_LT(time.small_late_ms, 0.9 * time.small_ms);
  const double whole_ms = Bench(setup, scene, pool).run(parseMethod("irradiance_cache"), 8, 1).cpu_ms;
  EXPECT_GT(time.small_ms, 0.1 * whole_ms);
  EXPECT_LT(time.small_ms, 0.6 * whole_ms);
}

}  // namespace
}  // namespace saccade::eval
