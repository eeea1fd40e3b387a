#include "eval/bench/refine_bench.h"

#include <gtest/gtest.h>

#include "feed/room.h"
#include "methods/method_spec.h"

namespace saccade::eval {
namespace {

using namespace std::chrono_literals;

// Of refined intervals fewer events are wrong than of half intervals, and from fewer look-ups.
TEST(RefineBench, ComparesWithFinePlanes) {
  FeedConfig config;
  config.camera = pinhole(80, 72, 40), config.frame_rate_hz = 62.5, config.bounces = 1;
  config.params = parseMethod(config.method).params;
  config.refinement.emplace();
  const Trajectory right({{0ms, Pose{{0, 0, -0.9}, {}}}, {160ms, Pose{{0.4, 0, -0.9}, {}}}});
  const RefineResult r = measureRefinement({test::room(), right, config, 3, 16});
  EXPECT_GT(r.events, 100);
  EXPECT_LT(r.refined_errors.time, 0.5 * r.half_errors.time);
  EXPECT_LT(r.refined_errors.missed_share, r.half_errors.missed_share);
  EXPECT_GT(r.samples, 0);
  EXPECT_LT(r.samples, 0.5 * 3 * 16 * config.pixels());
  EXPECT_GT(r.fine_s, 0);
}

}  // namespace
}  // namespace saccade::eval
