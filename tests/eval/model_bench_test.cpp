#include "eval/bench/model_bench.h"

#include <gtest/gtest.h>

#include "scene/scratch.h"

namespace saccade::eval {
namespace {

struct ModelBenchTest : ::testing::Test {
  Scratch files;
  TilePool pool{2};

  ModelBench bench(const std::string& scene, const std::string& trajectory = "right") {
    BenchOptions o;
    o.setup = {.scene = scene,
               .trajectory = trajectory,
               .width = 24,
               .height = 18,
               .bounces = 2,
               .first = 2,
               .last = 2,
               .reference_spp = 64,
               .cache = files.path("cache")};
    return ModelBench(o, parseMethod("pt"), 1, pool);
  }
};

TEST_F(ModelBenchTest, TheWholeModelChangesNothing) {
  const ModelBench b = bench("textured-cornell-box");
  EXPECT_GT(b.whole().cpu_ms, 0);
  EXPECT_GT(b.events(), 0);
  EXPECT_GT(b.noise(), 0);
  const MeasuredModel same = b.measure({b.whole().model}).front();
  EXPECT_EQ(same.changed, 0);
  EXPECT_EQ(same.noise, 0);
  EXPECT_EQ(same.false_events + same.missed_events, 0);
}

// A feature that the scene lacks does the same.
TEST_F(ModelBenchTest, WithEqualSeedsOnlyWhatDiffersChanges) {
  const ModelBench b = bench("cornell-box");
  const auto models = b.measure({{2, {SceneFeature::kTextures}}, {1, {}}, {0, {}}});
  EXPECT_EQ(models[0].changed, 0);
  EXPECT_GT(models[2].changed, models[1].changed);
  EXPECT_LT(models[1].noise, b.noise());
  EXPECT_LT(models[2].cpu_ms, b.whole().cpu_ms);
}

TEST_F(ModelBenchTest, AStandingCameraHasNoEventsToChange) {
  const ModelBench b = bench("cornell-box", "still");
  EXPECT_EQ(b.events(), 0);
  EXPECT_EQ(b.measure({{0, {}}}).front().changed, 0);
}

}  // namespace
}  // namespace saccade::eval
