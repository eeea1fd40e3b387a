#include "eval/bench/bench.h"

#include "eval/bench/open_scene.h"
#include "eval/metrics/for_each_pixel.h"
#include "eval/metrics/plane_error.h"
#include "scene/scratch.h"

namespace saccade::eval {
namespace {

namespace fs = std::filesystem;

constexpr int kW = 32, kH = 24;

struct BenchTest : ::testing::Test {
  Scratch files;
  TilePool pool{2};
  BenchSetup setup{.scene = "cornell-box",
                   .width = kW,
                   .height = kH,
                   .bounces = 1,
                   .first = 3,
                   .last = 4,
                   .reference_spp = 64,
                   .cache = files.path("cache")};
  std::shared_ptr<const RenderScene> scene = openScene(setup.scene);

  // The reference frames that the bench renders for that motion.
  ImageF luminance(const Pose& pose) {
    Progress progress("reference", 1);
    ReferenceRenderer renderer(scene, {setup.bounces, scene->channels()}, kW, kH,
                               scene->description().fov_x_deg, setup.cache, pool);
    const ReferenceFrame frame = renderer.frame(pose, TimeNs{0}, setup.reference_spp, progress);
    ImageF mean(kW, kH);
    forEachPixel(mean, [&](int x, int y) { mean.at(x, y) = frame.mean(x, y); });
    return mean;
  }
};

void expectEqual(const ImageF& a, const ImageF& b) {
  forEachPixel(a, [&](int x, int y) { ASSERT_EQ(a.at(x, y), b.at(x, y)) << x << "," << y; });
}

TEST_F(BenchTest, RunsTheFramesOfAPlainFeed) {
  setup.reference_spp = 0;
  const Bench bench(setup, pool);
  EXPECT_TRUE(bench.truth().empty());
  const MethodSpec method = parseMethod("event_svgf:alpha=0.3");
  int frames = 0;
  const BenchRun run = bench.run(method, 4, 7, [&](const IntensityChange&) { ++frames; });
  EXPECT_EQ(frames, 4);
  ASSERT_EQ(run.changes.size(), 2u);
  EXPECT_GT(run.trace_ms, 0);
  EXPECT_GT(run.cpu_ms, run.trace_ms);

  FeedConfig config{
      .frame_rate_hz = 250, .method = method.name, .params = method.params, .spp = 4, .bounces = 1};
  config.camera = pinhole(scene->description().fov_x_deg, kW, kH), config.seed = 7;
  Feed feed(scene, openTrajectory("cornell-box", "right", *scene, {}), config, pool);
  for (int t = 1; t <= 4; ++t) {
    const IntensityChange& change = feed.step(pool);
    if (t < setup.first) continue;
    const IntensityChange& scored = run.changes[static_cast<std::size_t>(t - setup.first)];
    EXPECT_EQ(scored.frame, change.frame);
    EXPECT_EQ(scored.t1, change.t1);
    expectEqual(scored.dI, change.dI);
    expectEqual(scored.I_prev, change.I_prev);
  }
}

TEST_F(BenchTest, TheTruthIsOfTheFramesThatAreScored) {
  const Bench bench(setup, pool);
  const Trajectory path = openTrajectory("cornell-box", "right", *scene, {});
  ASSERT_EQ(bench.truth().size(), 2u);
  double error = 0;
  for (FrameIndex t = 3; t <= 4; ++t) {
    const Truth& truth = bench.truth()[t - 3];
    EXPECT_EQ(truth.change.t0, frameTime(t - 1, 250));
    EXPECT_EQ(truth.change.t1, frameTime(t, 250));
    EXPECT_EQ(truth.change.frame, t);
    expectEqual(truth.change.I_prev, luminance(path.at(frameTime(t - 1, 250))));
    expectEqual(truth.change.I_now, luminance(path.at(frameTime(t, 250))));
    error += truth.error() / 2;
  }
  EXPECT_DOUBLE_EQ(bench.referenceError(), error);
}

TEST_F(BenchTest, PassesTheScenesOwnPoseAtTheLastFrameWithTheSpeedAskedFor) {
  const ImageF home = luminance(scene->description().T_world_camera);
  // After a long way forward, the image is no longer as fast as at the end of a frame.
  const std::pair<const char*, double> asked[] = {
      {"right", 0.25}, {"right", 4}, {"forward", 0.25}, {"orbit", 0.5}, {"orbit", 4}};
  for (const auto& [motion, px] : asked) {
    setup.trajectory = motion, setup.px_per_frame = px;
    const Bench bench(setup, pool);
    EXPECT_NEAR(bench.medianPxPerFrame() / px, 1, 0.05) << motion << " at " << px;
    const IntensityChange& last = bench.truth().back().change;
    EXPECT_LT(relativeL1(last.I_now, home), 1e-3) << motion << " at " << px;
    EXPECT_GT(relativeL1(last.I_prev, home), 1e-2) << motion << " at " << px;
  }
}

TEST_F(BenchTest, ShakesAsTheMotionDoesAtTheRateOfTheSpeed) {
  setup.trajectory = "shake", setup.px_per_frame = 0.5;
  const Bench bench(setup, pool);
  const double rate_hz = kMotionRateHz * kMotionPxPerFrame / 0.5 * (kW / kMotionWidth);
  EXPECT_DOUBLE_EQ(bench.setup().frame_rate_hz, rate_hz);
  const Trajectory path = openTrajectory("cornell-box", "shake", *scene, {});
  expectEqual(bench.truth().back().change.I_now, luminance(path.at(frameTime(4, rate_hz))));
}

TEST_F(BenchTest, TellsWhatIsInView) {
  setup.reference_spp = 0, setup.px_per_frame = 0.5;
  const BenchView view = Bench(setup, scene, pool).view();
  EXPECT_GT(view.surface, 0.9);
  EXPECT_NEAR(view.px_per_frame, 0.5, 0.03);
  setup.trajectory = "still", setup.px_per_frame = 0;
  EXPECT_EQ(Bench(setup, scene, pool).view().px_per_frame, 0);
  Scene empty;
  const BenchView nothing = Bench(setup, std::make_shared<RenderScene>(empty), pool).view();
  EXPECT_EQ(nothing.surface, 0);
  EXPECT_EQ(nothing.px_per_frame, 0);
}

TEST_F(BenchTest, TakesItsReferencesFromTheCacheTheSecondTime) {
  const Bench first(setup, pool);
  std::map<fs::path, fs::file_time_type> written;
  for (const auto& file : fs::directory_iterator(setup.cache)) written[file.path()] = file.last_write_time();
  EXPECT_EQ(written.size(), 3u);
  const Bench second(setup, pool);
  for (std::size_t f = 0; f < 2; ++f) {
    expectEqual(first.truth()[f].half_a, second.truth()[f].half_a);
    expectEqual(first.truth()[f].half_b, second.truth()[f].half_b);
  }
  for (const auto& file : fs::directory_iterator(setup.cache))
    EXPECT_EQ(file.last_write_time(), written[file.path()]);
}

}  // namespace
}  // namespace saccade::eval
