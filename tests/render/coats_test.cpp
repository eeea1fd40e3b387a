// Light of the coats of plastics, apart from that of their bases.
#include <gtest/gtest.h>

#include "render/renderer.h"
#include "render/test_scenes.h"

namespace saccade {
namespace {

constexpr int kSize = 16;
constexpr int kBounces = 2;

// A floor, half of it plastic, beside a wall and under a lamp and a ceiling.
Scene plasticRoom(BsdfKind kind) {
  Scene s;
  Material plastic = test::grey(0.3f);
  plastic.model.kind = kind, plastic.model.alpha = 0.2f, plastic.model.microfacets = MicrofacetKind::kGgx;
  s.materials = {plastic, test::grey(0.6f)};
  s.meshes = {test::quad({-2, -2, 0}, {2.5f, 0, 0}, {0, 4, 0}, 0),
              test::quad({0.5f, -2, 0}, {1.5f, 0, 0}, {0, 4, 0}, 1),
              test::quad({-2, -2, 0}, {0, 4, 0}, {0, 0, 4}, 1),
              test::quad({1, -0.3f, 3.5f}, {0, 0.6f, 0}, {0.6f, 0, 0}, 1, {20, 20, 20}),
              test::quad({-2, -2, 3.8f}, {0, 4, 0}, {4, 0, 0}, 1)};
  s.T_world_camera = {{0, 0, 3}, {1, 0, 0, 0}};  // half a turn about x: looks down
  s.fov_x_deg = 50;
  return s;
}

// Two frames of a camera that moves by `step` to the right.
struct Coats {
  Frame before{kSize, kSize, 1}, now{kSize, kSize, 1};
  Frame whole{kSize, kSize};  // the same as `now` by a method that tells no parts
};

Coats render(BsdfKind kind, double step, int paths, int threads = 2) {
  const Scene scene = plasticRoom(kind);
  const PosedScene posed(std::make_shared<RenderScene>(scene));
  TilePool pool(threads);
  Pose moved = scene.T_world_camera;
  moved.position.x += step;
  const CameraModel lens = pinhole(scene.fov_x_deg, kSize, kSize);
  const Camera first(scene.T_world_camera, lens), second(moved, lens);
  Renderer renderer({kBounces, 1});
  Coats frames;
  const auto seeds = [&](FrameIndex t) { return SeedPlan::independent(1, t, paths); };
  const auto renderOne = [&](const PixelContext& view, FrameIndex t, Frame& out) {
    const SurfaceFrame next = renderer.renderSurfaces(view, pool, out);
    for (int y = 0; y < kSize; ++y)
      for (SurfacePoint& p : out.surfaces->row(y)) p.paths = static_cast<std::uint32_t>(paths);
    renderer.renderPaths(view.now, seeds(t), next, nullptr, pool);
  };
  renderOne(PixelContext({posed, first}), 0, frames.before);
  const PixelContext view({posed, second}, {posed, first});
  renderOne(view, 1, frames.now);
  renderer.renderCoats(view, seeds(1), frames.before, nullptr, pool, frames.now);
  renderer.render(view, seeds(1), pool, frames.whole);
  return frames;
}

// Over the pixels that show plastic in this frame.
template <class F>
double meanOfPlastic(const Coats& frames, const F& f) {
  double sum = 0, n = 0;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x)
      if (frames.now.surfaces->hasCoat(x, y)) sum += f(x, y), n += 1;
  return sum / n;
}

class CoatsOf : public testing::TestWithParam<BsdfKind> {};
INSTANTIATE_TEST_SUITE_P(Plastics, CoatsOf, testing::Values(BsdfKind::kPlastic, BsdfKind::kRoughPlastic));

TEST_P(CoatsOf, AndBasesReflectTheWholeLight) {
  const Coats frames = render(GetParam(), 0.01, 2048);
  const double whole = meanOfPlastic(frames, [&](int x, int y) { return frames.whole.samples.I2.at(x, y); });
  const double coat = meanOfPlastic(frames, [&](int x, int y) { return frames.now.coats->now.at(x, y); });
  const double base = meanOfPlastic(frames, [&](int x, int y) { return frames.now.samples.I2.at(x, y); });
  EXPECT_GT(coat, 0.01 * whole);
  EXPECT_NEAR(base + coat, whole, 0.005 * whole);
}

TEST_P(CoatsOf, PixelsThatShowPlasticInAFrame) {
  const Coats frames = render(GetParam(), 0.3, 2);
  int one = 0, none = 0;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const bool now = frames.now.surfaces->hasCoat(x, y), before = frames.before.surfaces->hasCoat(x, y);
      const CoatSamples& coats = *frames.now.coats;
      EXPECT_EQ(coats.pairs.count.at(x, y) > 0, now || before);
      EXPECT_TRUE(now || coats.now.at(x, y) == 0);
      EXPECT_TRUE(before || coats.pairs.before.at(x, y) == 0);
      one += now != before, none += !now && !before;
    }
  EXPECT_GT(one, kSize / 2);
  EXPECT_GT(none, kSize);
}

TEST_P(CoatsOf, AStandingCameraAreEqual) {
  const Coats frames = render(GetParam(), 0, 2);
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x)
      ASSERT_EQ(frames.now.coats->pairs.before.at(x, y), frames.now.coats->now.at(x, y)) << x << ' ' << y;
}

TEST_P(CoatsOf, AnyNumberOfThreadsAreTheSame) {
  const Coats one = render(GetParam(), 0.1, 1, 1), other = render(GetParam(), 0.1, 1, 5);
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      ASSERT_EQ(one.now.coats->now.at(x, y), other.now.coats->now.at(x, y));
      ASSERT_EQ(one.now.coats->pairs.before.at(x, y), other.now.coats->pairs.before.at(x, y));
      ASSERT_EQ(one.now.coats->pairs.variance.at(x, y), other.now.coats->pairs.variance.at(x, y));
    }
}

}  // namespace
}  // namespace saccade
