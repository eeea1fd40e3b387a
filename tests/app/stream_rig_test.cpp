#include "app/sequence/stream_rig.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/request/resolve_parts.h"
#include "feed/room.h"

namespace saccade {
namespace {

constexpr int kWidth = 64, kHeight = 8;
constexpr double kBaseline = 0.25;

// Two cameras of a focal length of kWidth / 2, the second at T_body_camera.
ResolvedStream stereo(const Pose& T_body_camera) {
  ResolvedStream stream;
  stream.T_body_camera = {Pose{}, T_body_camera};
  FeedConfig& feed = stream.feed;
  feed.camera = pinhole(90, kWidth, kHeight), feed.seed = 5, feed.method = "svgf";
  std::string bad_name;
  EXPECT_EQ(resolveParams(*findMethod(feed.method), {}, feed.params, bad_name), "");
  stream.further.push_back(feed);
  shareSettings(stream);
  return stream;
}

// Its depth grows to the right: z = 4 + x / 2.
std::shared_ptr<const RenderScene> slantedWall() {
  Scene s;
  s.materials = {test::grey(0.5f)};
  s.meshes = {test::quad({-20, -20, -6}, {40, 0, 20}, {0, 40, 0}, 0)};
  return std::make_shared<RenderScene>(std::move(s));
}

const Trajectory kStill{{{TimeNs{0}, {}}}};

// A point at depth z has the disparity f B / z, and the inverse depth of a plane is linear in the picture.
TEST(StreamRig, DisparityIsFocalLengthTimesBaselineOverDepth) {
  TilePool pool(1);
  Rig rig = makeRig(slantedWall(), kStill, stereo({{kBaseline, 0, 0}, {}}), {pool});
  const auto& views = rig.step({pool});
  const ImageF &left = views[0].rendered->frames.cur.g.z, &right = views[1].rendered->frames.cur.g.z;
  int compared = 0;
  for (int x = 0; x < kWidth; ++x) {
    const double z = left.at(x, 3), there = x - kWidth / 2.0 * kBaseline / z;
    const int pixel = static_cast<int>(std::floor(there));
    if (pixel < 0) continue;
    const double part = there - pixel;
    const double inverse = (1 - part) / right.at(pixel, 3) + part / right.at(pixel + 1, 3);
    EXPECT_NEAR(1 / inverse, z, 1e-5 * z) << x;
    ++compared;
  }
  EXPECT_GT(compared, kWidth / 2);
}

TEST(StreamRig, EqualViewsHaveEqualDepthAndNoiseOfTheirOwn) {
  TilePool pool(1);
  Rig rig = makeRig(test::room(), kStill, stereo({}), {pool});
  const auto& views = rig.step({pool});
  const FrameSamples &a = views[0].rendered->frames.cur.samples, &b = views[1].rendered->frames.cur.samples;
  int equal = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      EXPECT_EQ(views[0].rendered->frames.cur.g.z.at(x, y), views[1].rendered->frames.cur.g.z.at(x, y));
      equal += a.I2.at(x, y) == b.I2.at(x, y);
    }
  }
  EXPECT_LT(equal, kWidth * kHeight / 4);
}

// A body that turns to the right by a radian per second swings a camera 2 ahead of it to the right.
TEST(StreamRig, TheFastestViewTellsThePixelSpeed) {
  TilePool pool(1);
  const Trajectory turning({{TimeNs{0}, {}}, {TimeNs{1'000'000'000}, {{}, axisAngle({0, 1, 0})}}});
  const auto scene = slantedWall();
  const ResolvedStream stream = stereo({{0, 0, 2}, {}});
  const Rig rig = makeRig(scene, turning, stream, {pool});
  const PixelSpeed ahead = measurePixelSpeed(*scene, turning.mounted({{0, 0, 2}, {}}), stream.feed, 10);
  const PixelSpeed body = measurePixelSpeed(*scene, turning, stream.feed, 10);
  EXPECT_EQ(rig.pixelSpeed(10).p99, std::max(ahead.p99, body.p99));
  EXPECT_NE(ahead.p99, body.p99);
}

}  // namespace
}  // namespace saccade
