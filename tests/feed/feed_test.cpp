// From a scene to events, on a small room.
#include "feed/feed.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/counting_new.h"
#include "events/sensor.h"
#include "feed/room.h"
#include "render/test_scenes.h"

namespace saccade {
namespace {

using namespace std::chrono_literals;
using test::room;

constexpr int kW = 40, kH = 30;

// A lamp that is off from frame 3 to frame 5.
Strength blinking() {
  return Strength({{0ms, 1}, {30ms, 1}, {30ms, 0}, {60ms, 0}, {60ms, 1}});
}

// A camera that stands, or moves right by 0.005 a frame.
Trajectory path(bool moving) {
  const Pose home{{0, 0, -0.9}, {}};
  return Trajectory({{TimeNs(0), home}, {TimeNs(1'000'000'000), Pose{{moving ? 0.5 : 0, 0, -0.9}, {}}}});
}

FeedConfig config(const std::string& method, bool jitter = false) {
  FeedConfig c;
  c.jitter = jitter;
  c.camera = pinhole(80, kW, kH), c.frame_rate_hz = 100, c.method = method, c.seed = 3;
  std::string name;
  EXPECT_EQ(resolveParams(*findMethod(method), {}, c.params, name), "");
  return c;
}

double largestChange(const IntensityChange& change) {
  double largest = 0;
  for (int y = 0; y < kH; ++y) {
    for (int x = 0; x < kW; ++x) largest = std::max<double>(largest, std::abs(change.dI.at(x, y)));
  }
  return largest;
}

// Correlated seeds and the corrected recursion leave a standing picture unchanged, bit for bit, from the
// first frame on.
TEST(Feed, AStandingSceneChangesByExactlyNothingAndFiresNoEvent) {
  TilePool pool(2);
  for (const FeedConfig& c :
       {config("event_svgf"), config("irradiance_cache"), config("irradiance_cache", true), config("relax"),
        config("adaptive_denoising"), config("pt-correlated")}) {
    Feed feed(room(), path(false), c, pool);
    Sensor sensor({.threshold = 0.01, .threshold_off = 0.01, .bias = 1e-8}, kW, kH);
    SensorOutput out;
    for (int t = 1; t <= 300; ++t) {
      const IntensityChange& change = feed.step(pool);
      ASSERT_EQ(largestChange(change), 0) << c.method << " frame " << t;
      sensor.generate(change, out);
      ASSERT_TRUE(out.events.empty());
      ASSERT_GT(change.I_prev.at(kW / 2, kH / 2), 0);
    }
  }
}

// The error at the moment when the camera stops stays as it is. It does not fade, because fading would cause
// events in a picture at rest.
TEST(Feed, ACameraThatStopsFallsSilent) {
  TilePool pool(2);
  const Pose home{{0, 0, -0.9}, {}}, there{{0.1, 0, -0.9}, {}};
  Feed feed(room(), Trajectory({{0ms, home}, {200ms, there}, {3000ms, there}}), config("event_svgf"), pool);
  Sensor sensor({}, kW, kH);
  SensorOutput out;
  std::size_t early = 0, late = 0;  // the camera stops at frame 20; the filter's memory fades
  for (int t = 1; t <= 250; ++t) {
    sensor.generate(feed.step(pool), out);
    (t <= 100 ? early : late) += out.events.size();
  }
  EXPECT_GT(early, 100u);
  EXPECT_EQ(late, 0u);
}

TEST(Feed, ALampThatIsSwitchedChangesThePictureInThatFrameAlone) {
  TilePool pool(2);
  const Strength lamp({{0ms, 1}, {50ms, 1}, {50ms, 0.25f}});
  Feed switched(room(lamp), path(false), config("pt-correlated"), pool);
  Feed steady(room(), path(false), config("pt-correlated"), pool);
  for (int t = 1; t <= 8; ++t) {
    const IntensityChange &change = switched.step(pool), &base = steady.step(pool);
    EXPECT_EQ(largestChange(change) > 0, t == 5);  // 50 ms at 100 Hz
    for (int y = 0; y < kH; ++y) {
      for (int x = 0; x < kW; ++x) {
        ASSERT_EQ(change.I_prev.at(x, y), (t > 5 ? 0.25f : 1) * base.I_prev.at(x, y)) << "frame " << t;
        ASSERT_EQ(change.I_now.at(x, y), (t >= 5 ? 0.25f : 1) * base.I_now.at(x, y)) << "frame " << t;
      }
    }
  }
}

TEST(Feed, ThroughALensAStandingCameraSeesNoChange) {
  TilePool pool(2);
  for (const bool jitter : {false, true}) {
    FeedConfig c = config("event_svgf");
    c.jitter = jitter;
    c.camera.distortion = {LensModel::kEquidistant, {-0.02, 0.01, 0, 0, 0}};
    const auto scene = std::make_shared<RenderScene>(test::furnace(0.5f, 1));
    Feed feed(scene, Trajectory({{0ms, scene->description().T_world_camera}}), c, pool);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(largestChange(feed.step(pool)), 0);
  }
}

// A surface that appears has no history. The filter averages it with neighbours that appeared with it.
TEST(Feed, ASurfaceThatAppearsIsFiltered) {
  Scene s = test::floorFromAbove(0.5f);
  s.meshes.push_back(test::quad({1, -1, 1}, {0, 0, 2}, {0, 2, 0}, 0, {9, 9, 9}));
  const Pose down = s.T_world_camera, up{down.position, {}};
  const Trajectory turn({{0ms, up}, {9ms, up}, {10ms, down}});
  const auto scene = std::make_shared<RenderScene>(std::move(s));
  TilePool pool(2);
  const auto noiseOf = [&](const char* method) {
    FeedConfig c = config(method);
    c.camera = pinhole(10, kW, kH);
    Feed feed(scene, turn, c, pool);
    EXPECT_EQ(largestChange(feed.change()), 0);
    const ImageF& dI = feed.step(pool).dI;
    double sum = 0, squares = 0;
    for (int y = 0; y < kH; ++y) {
      for (int x = 0; x < kW; ++x) sum += dI.at(x, y), squares += dI.at(x, y) * dI.at(x, y);
    }
    const double mean = sum / (kW * kH);
    return std::sqrt(squares / (kW * kH) - mean * mean) / mean;
  };
  EXPECT_LT(noiseOf("event_svgf"), 0.3 * noiseOf("pt-correlated"));
}

class FeedOf : public testing::TestWithParam<FeedConfig> {};
INSTANTIATE_TEST_SUITE_P(, FeedOf,
                         testing::Values(config("event_svgf"), config("irradiance_cache"),
                                         config("irradiance_cache", true), config("a_svgf"), config("relax"),
                                         config("adaptive_denoising"), config("adaptive_sampling"),
                                         config("adaptive_sampling", true)),
                         [](const auto& info) {
                           return info.param.method + (info.param.jitter ? "_jittered" : "");
                         });

TEST_P(FeedOf, IsTheSameForAnyNumberOfThreads) {
  TilePool one(1), three(3);
  Feed a(room(), path(true), GetParam(), one), b(room(), path(true), GetParam(), three);
  for (int t = 1; t <= 6; ++t) {
    const IntensityChange &x = a.step(one), &y = b.step(three);
    for (int row = 0; row < kH; ++row) {
      for (int column = 0; column < kW; ++column) {
        ASSERT_EQ(x.dI.at(column, row), y.dI.at(column, row));
        ASSERT_EQ(x.var_dI.at(column, row), y.var_dI.at(column, row));
      }
    }
  }
}

TEST(Feed, GivesFinitePicturesAndTiledTimes) {
  TilePool pool(2);
  for (const MethodInfo& method : methodTable()) {
    Feed feed(room(blinking()), path(true), config(method.name), pool);
    for (int t = 1; t <= 8; ++t) {
      const IntensityChange& change = feed.step(pool);
      EXPECT_EQ(change.t0, TimeNs((t - 1) * 10'000'000));
      EXPECT_EQ(change.t1, TimeNs(t * 10'000'000));
      for (const ImageF* plane :
           {&change.dI, &change.I_prev, &change.I_now, &change.var_dI, &change.var_I_prev}) {
        for (int y = 0; y < kH; ++y) {
          for (int x = 0; x < kW; ++x) ASSERT_TRUE(std::isfinite(plane->at(x, y))) << method.name;
        }
      }
    }
    EXPECT_GT(largestChange(feed.change()), 0);
  }
}

TEST(Feed, AllocatesNothingAfterTwoFrames) {
  TilePool pool(1);  // a second thread allocates in its first tile, whenever that is
  Feed feed(room(Strength({{0ms, 1}})), path(true), config("event_svgf"), pool);  // looked up in every frame
  Sensor sensor({}, kW, kH);
  SensorOutput out;
  for (int t = 1; t <= 2; ++t) sensor.generate(feed.step(pool), out);
  const int before = test::allocations();
  for (int t = 3; t <= 8; ++t) sensor.generate(feed.step(pool), out);
  EXPECT_EQ(test::allocations(), before);
}

TEST(Feed, NorDoesAnyOtherMethodOfPictures) {
  TilePool pool(1);
  for (const char* method : {"svgf", "a_svgf", "relax", "adaptive_denoising", "adaptive_sampling"}) {
    Feed feed(room(Strength({{0ms, 1}})), path(true), config(method), pool);
    for (int t = 1; t <= 2; ++t) feed.step(pool);
    const int before = test::allocations();
    for (int t = 3; t <= 8; ++t) feed.step(pool);
    EXPECT_EQ(test::allocations(), before) << method;
  }
}

TEST(Feed, TellsTheLuminanceOfItsFirstFrame) {
  TilePool pool(2);
  const Feed feed(room(), path(true), config("event_svgf"), pool);
  EXPECT_LT(feed.firstFrameLuminance(0.01), feed.firstFrameLuminance(0.5));
  EXPECT_GT(feed.firstFrameLuminance(0.01), 0);
}

}  // namespace
}  // namespace saccade
