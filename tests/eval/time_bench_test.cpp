#include "eval/bench/time_bench.h"

#include <gtest/gtest.h>

#include <vector>

#include "eval/bench/open_scene.h"

namespace saccade::eval {
namespace {

// A picture of 5x4 pixels, so that one of 2x2 is measured: a quarter of its pixels are 5.
BenchSetup tinySetup() {
  BenchSetup setup;
  setup.width = 5, setup.height = 4, setup.first = setup.last = 2, setup.reference_spp = 0;
  return setup;
}

TEST(TimeBench, TellsEarlyAndLateFramesApart) {
  TilePool pool(1);
  const BenchSetup setup = tinySetup();
  const std::vector<double> frame_ms{8, 4, 100, 100, 3, 1};
  const MeasuredTime time = TimeBench(setup, openScene(setup.scene), pool).meansOf(frame_ms);
  EXPECT_DOUBLE_EQ(time.small_ms, 6 * 5.0 / 4);
  EXPECT_DOUBLE_EQ(time.small_late_ms, 2 * 5.0 / 4);
}

TEST(TimeBench, MeasuresFramesOfAMethod) {
  TilePool pool(1);
  const BenchSetup setup = tinySetup();
  const MeasuredTime time =
      TimeBench(setup, openScene(setup.scene), pool).run(parseMethod("irradiance_cache"), 2);
  EXPECT_GT(time.small_ms, 0);
  EXPECT_GT(time.small_late_ms, 0);
}

}  // namespace
}  // namespace saccade::eval
