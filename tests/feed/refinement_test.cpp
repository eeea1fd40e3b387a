// Updates within intervals, against whole frames of the same times.
#include "feed/refinement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "base/counting_new.h"
#include "feed/baker.h"
#include "feed/feed.h"
#include "feed/room.h"
#include "scene/motion/bodies.h"

namespace saccade {
namespace {

using namespace std::chrono_literals;
using test::room;

constexpr int kW = 72, kH = 40, kPieces = 16;
constexpr double kRate = 62.5;  // an interval is 16 ms long

FeedConfig config() {
  FeedConfig c;
  c.camera = pinhole(80, kW, kH), c.frame_rate_hz = kRate, c.method = "irradiance_cache", c.bounces = 1;
  c.refinement.emplace();
  std::string name;
  EXPECT_EQ(resolveParams(*findMethod(c.method), {}, c.params, name), "");
  return c;
}

// Whole frames alone, and as many in an interval as there are pieces.
FeedConfig fine(FeedConfig c) {
  c.frame_rate_hz *= kPieces, c.refinement->finest_px = 1e9;
  return c;
}

// Right by about 1 px of the far wall in each interval.
Trajectory path(double speed = 1) {
  return Trajectory({{0ms, Pose{{0, 0, -0.9}, {}}}, {160ms, Pose{{0.4 * speed, 0, -0.9}, {}}}});
}

std::shared_ptr<const BakedLight> bakeOf(const std::shared_ptr<const RenderScene>& scene, PoolHandle pool) {
  Baker baker(scene, planBake(*scene, path(), config(), 10, 0.1));
  while (!baker.isDone()) baker.pass(pool);
  return baker.light(pool);
}

struct RefinementTest : testing::Test {
  FeedConfig baked() {
    FeedConfig c = config();
    c.baked = bakeOf(scene, pool);
    return c;
  }
  const std::shared_ptr<const RenderScene> scene = room();
  TilePool pool{2};
};

float logOf(float I) {
  return std::log(I + 1e-3f);
}

TEST_F(RefinementTest, UpdatesAreSortedAndInsideTheInterval) {
  Feed feed(scene, path(), baked(), pool);
  for (int t = 0; t < 3; ++t) {
    const auto& updates = feed.step(pool).updates;
    ASSERT_GT(updates.size(), 100u);
    EXPECT_EQ(feed.refined().samples, updates.size());
    EXPECT_EQ(feed.refined().unsplit, 0u);
    for (std::size_t i = 0; i < updates.size(); ++i) {
      const IntensityUpdate& u = updates[i];
      ASSERT_LT(u.pixel, unsigned{kW * kH});
      ASSERT_GT(u.at, 0);
      ASSERT_LT(u.at, 1);
      ASSERT_GE(u.I, 0);
      if (i > 0) {
        ASSERT_LT(std::pair(updates[i - 1].at, updates[i - 1].pixel), std::pair(u.at, u.pixel));
      }
    }
  }
}

// Both ends are those of whole frames, too: what lies between two updates is near the line.
TEST_F(RefinementTest, BakedUpdatesShowWhatFramesShow) {
  const FeedConfig c = baked();
  Feed feed(scene, path(), c, pool), frames(scene, path(), fine(c), pool);
  double off = 0, off_line = 0, off_end = 0, found = 0;
  for (int t = 0; t < 2; ++t) {
    std::vector<ImageF> I;
    for (int k = 1; k <= kPieces; ++k) {
      I.emplace_back(kW, kH);
      I.back().copyFrom(frames.step(pool).I_now);
    }
    const IntensityChange& change = feed.step(pool);
    std::map<std::uint32_t, std::vector<std::pair<float, float>>> lines;
    for (std::uint32_t p = 0; p < kW * kH; ++p)
      lines[p] = {{0.f, logOf(change.I_prev.at(static_cast<int>(p) % kW, static_cast<int>(p) / kW))}};
    for (const IntensityUpdate& u : change.updates) {
      const int x = static_cast<int>(u.pixel) % kW, y = static_cast<int>(u.pixel) / kW;
      const float k = u.at * kPieces;
      lines[u.pixel].emplace_back(u.at, logOf(u.I));
      if (k != std::floor(k)) continue;
      ++found;
      off += std::abs(u.I - I[static_cast<std::size_t>(k) - 1].at(x, y)) > 1e-3f * u.I;
    }
    for (auto& [p, line] : lines) {
      const int x = static_cast<int>(p) % kW, y = static_cast<int>(p) / kW;
      line.emplace_back(1.f, logOf(change.I_now.at(x, y)));
      off_end += std::abs(change.I_now.at(x, y) - I.back().at(x, y)) > 1e-3f * I.back().at(x, y);
      for (int k = 1; k < kPieces; ++k) {
        const float at = static_cast<float>(k) / kPieces;
        const auto next = std::ranges::find_if(line, [&](const auto& end) { return end.first >= at; });
        const auto [t0, L0] = next[-1];
        const auto [t1, L1] = *next;
        const float L = L0 + (at - t0) / (t1 - t0) * (L1 - L0);
        off_line += std::abs(L - logOf(I[static_cast<std::size_t>(k) - 1].at(x, y))) > 0.1 * 0.2;
      }
    }
  }
  EXPECT_GT(found, 1000);
  EXPECT_LT(off, 0.01 * found);
  EXPECT_LT(off_end, 0.01 * 2 * kW * kH);
  EXPECT_LT(off_line, 0.01 * 2 * kW * kH * kPieces);
}

// The light that is learned stands still within an interval, so that updates lie between both ends.
TEST_F(RefinementTest, LearnsWithoutABake) {
  Feed feed(scene, path(), config(), pool);
  for (int t = 0; t < 4; ++t) feed.step(pool);
  EXPECT_GT(feed.change().updates.size(), 100u);
  EXPECT_LT(feed.change().updates.size(), 4u * kW * kH);
  double beside = 0;
  for (const IntensityUpdate& u : feed.change().updates) {
    const int x = static_cast<int>(u.pixel) % kW, y = static_cast<int>(u.pixel) / kW;
    float low = 1e9f, high = 0;
    for (int j = std::max(0, y - 3); j <= std::min(kH - 1, y + 3); ++j)
      for (int i = std::max(0, x - 3); i <= std::min(kW - 1, x + 3); ++i)
        for (const ImageF* plane : {&feed.change().I_prev, &feed.change().I_now})
          low = std::min(low, plane->at(i, j)), high = std::max(high, plane->at(i, j));
    beside += u.I < 0.8f * low || u.I > 1.25f * high;
  }
  EXPECT_LT(beside, 0.02 * static_cast<double>(feed.change().updates.size()));
}

// Few rays end otherwise between two moments at which they end alike.
TEST_F(RefinementTest, TracesTheRaysThatChange) {
  FeedConfig every = config();
  every.refinement->every_ray = true;
  Feed feed(scene, path(), config(), pool), all(scene, path(), every, pool);
  std::size_t rays = 0, all_rays = 0, common = 0, other = 0;
  for (int t = 0; t < 4; ++t) {
    std::map<std::pair<float, std::uint32_t>, float> I;
    for (const IntensityUpdate& u : all.step(pool).updates) I[{u.at, u.pixel}] = u.I;
    for (const IntensityUpdate& u : feed.step(pool).updates)
      if (const auto found = I.find({u.at, u.pixel}); found != I.end())
        ++common, other += std::abs(u.I - found->second) > 1e-4f * u.I;
    rays += feed.refined().rays, all_rays += all.refined().rays;
  }
  EXPECT_GT(all_rays, 200u);
  EXPECT_LT(rays, 0.9 * static_cast<double>(all_rays));
  EXPECT_GT(common, 1000u);
  EXPECT_LT(other, 0.01 * static_cast<double>(common));
}

TEST_F(RefinementTest, AStandingCameraHasNone) {
  Feed feed(scene, path(0), baked(), pool);
  for (int t = 0; t < 3; ++t) {
    EXPECT_TRUE(feed.step(pool).updates.empty());
    EXPECT_EQ(feed.refined().samples, 0u);
  }
}

TEST_F(RefinementTest, WithoutTheSettingThereAreNone) {
  FeedConfig c = baked();
  c.refinement.reset();
  Feed feed(scene, path(), c, pool);
  EXPECT_TRUE(feed.step(pool).updates.empty());
}

TEST_F(RefinementTest, IsTheSameForAnyNumberOfThreads) {
  const FeedConfig c = baked();
  TilePool one(1), three(3);
  Feed a(scene, path(), c, one), b(scene, path(), c, three);
  for (int t = 0; t < 3; ++t) {
    const auto &x = a.step(one).updates, &y = b.step(three).updates;
    ASSERT_EQ(x.size(), y.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
      ASSERT_EQ(x[i].pixel, y[i].pixel);
      ASSERT_EQ(x[i].at, y[i].at);
      ASSERT_EQ(x[i].I, y[i].I);
    }
  }
}

// A camera that goes to and fro. Frames alone may allocate: where the bake knows nothing they learn.
TEST_F(RefinementTest, AllocatesNothingInTheSteadyState) {
  std::vector<TimedPose> keys;
  for (int t = 0; t <= 20; ++t) keys.push_back({t * 16ms, Pose{{t % 2 * 0.04, 0, -0.9}, {}}});
  TilePool one(1);
  const auto allocationsOf = [&](const FeedConfig& c, std::size_t least_updates) {
    Feed feed(scene, Trajectory(keys), c, one);
    for (int t = 1; t <= 10; ++t) feed.step(one);
    const int before = test::allocations();
    for (int t = 11; t <= 18; ++t) EXPECT_GE(feed.step(one).updates.size(), least_updates);
    return test::allocations() - before;
  };
  const FeedConfig refined = baked();
  FeedConfig frames = refined;
  frames.refinement->finest_px = 1e9;
  EXPECT_EQ(allocationsOf(refined, 100), allocationsOf(frames, 0));
}

TEST_F(RefinementTest, KeepsPiecesWholeWhereATileHasNoRoom) {
  Scene noise = test::furnace(0.6f, 0);
  noise.materials[0].reflectance = {.kind = SurfaceColor::Kind::kCheckerboard,
                                    .color0 = {0.9f, 0.9f, 0.9f},
                                    .color1 = {0.05f, 0.05f, 0.05f},
                                    .uv_scale = {24, 24}};
  noise.meshes.push_back(test::quad({-0.3f, -0.95f, -0.3f}, {0, 0, 0.6f}, {0.6f, 0, 0}, 0, {9, 9, 9}));
  const auto dense = std::make_shared<RenderScene>(std::move(noise));
  Feed feed(dense, path(4), config(), pool);
  const IntensityChange& change = feed.step(pool);
  EXPECT_GT(feed.refined().unsplit, 0u);
  EXPECT_LE(static_cast<double>(change.updates.size()), config().refinement->most_updates * kW * kH);
  EXPECT_GT(change.updates.size(), 7u * kW * kH) << "pieces far from their lines take what is left";
}

// A lamp, a floor, and a card between them that moves.
Scene floorUnderACard() {
  Scene s = test::floorFromAbove(0.5f);
  s.meshes.push_back(test::quad({-0.05f, -0.05f, 2}, {0, 0.1f, 0}, {0.1f, 0, 0}, 0, {900, 900, 900}));
  s.meshes.push_back(test::quad({0.1f, -0.2f, 0.6f}, {0.3f, 0, 0}, {0, 0.4f, 0}, 0));
  s.meshes.back().name = "card";
  s.T_world_camera = {{0, 0, 1.5}, {1, 0, 0, 0}};
  s.fov_x_deg = 60;
  const std::string names[]{"card"};
  setBodies(s, names);
  return s;
}
// The card goes so far in ten intervals.
Feed feedOfCard(const Scene& s, Vec3d way, PoolHandle pool) {
  FeedConfig c = config();
  c.camera = pinhole(60, kW, kH);
  const Vec3d start = toDouble(s.bodies[0].centre());
  c.body_paths = {Trajectory({{0ms, {start, {}}}, {160ms, {start + way, {}}}})};
  return Feed(std::make_shared<RenderScene>(s), Trajectory({{0ms, s.T_world_camera}}), c, pool);
}

// A card moves before a wall that stands: its edge is refined, and with it the edge of its shadow.
TEST_F(RefinementTest, BodiesThatMoveAreRefined) {
  const Scene s = floorUnderACard();
  Feed feed = feedOfCard(s, {-0.2, 0, 0}, pool);
  for (int t = 0; t < 6; ++t) feed.step(pool);
  const IntensityChange& change = feed.change();
  int of_body = 0, of_floor = 0;
  for (const IntensityUpdate& u : change.updates) {
    const int x = static_cast<int>(u.pixel) % kW, y = static_cast<int>(u.pixel) / kW;
    const bool body = feed.frames().cur.g.body.at(x, y) > 0 || feed.frames().prev.g.body.at(x, y) > 0;
    ++(body ? of_body : of_floor);
    EXPECT_LT(u.I, 1.2f * std::max(change.I_now.at(kW - 1, kH / 2), change.I_prev.at(kW / 2, kH / 2)) + 50);
  }
  EXPECT_GT(of_body, 20);
  EXPECT_GT(of_floor, 20);
}

// Its shadow jumps by more pixels than a tile may look around.
TEST_F(RefinementTest, ABodyMayMoveFurtherThanTilesLook) {
  const Scene s = floorUnderACard();
  for (const double way : {-20., -2000.}) {
    Feed feed = feedOfCard(s, {way, 0, 0}, pool);
    for (int t = 0; t < 3; ++t) feed.step(pool);
    for (const IntensityUpdate& u : feed.change().updates) ASSERT_LT(u.pixel, unsigned{kW * kH}) << way;
  }
}

// A lit strip before a dark wall passes a pixel at a quarter of an interval. Neither end shows it, nor does
// the middle. A broad one beside it tells of the contrast.
TEST(RefinedDetail, ComesAndGoesBeforeTheMiddle) {
  const float pixel = Camera(Pose{}, config().camera).pixel;
  Scene s;
  s.materials = {test::grey(0)};
  s.meshes = {test::quad({-3, -3, 1.01f}, {0, 6, 0}, {6, 0, 0}, 0)};
  const auto addStrip = [&](float from, float to) {  // in pixels right of the centre of pixel kW / 2
    s.meshes.push_back(
        test::quad({(0.5f + from) * pixel, -1, 1}, {0, 2, 0}, {(to - from) * pixel, 0, 0}, 0, {1, 1, 1}));
  };
  addStrip(0.15f, 0.35f), addStrip(2.5f, 9);
  TilePool pool(1);
  Feed feed(std::make_shared<RenderScene>(s),
            Trajectory({{0ms, Pose{}}, {160ms, Pose{{10 * pixel, 0, 0}, {}}}}), config(), pool);
  const auto& updates = feed.step(pool).updates;
  EXPECT_TRUE(std::ranges::any_of(updates, [](const IntensityUpdate& u) {
    return u.pixel == kH / 2 * kW + kW / 2 && u.at == 0.25f && u.I > 0.5f;
  }));
}

TEST(RefinementFault, NamesWhatHasWholeFramesOnly) {
  FeedConfig c = config();
  EXPECT_EQ(refinementFault(c), "");
  c.jitter = true;
  EXPECT_NE(refinementFault(c).find("whole frames only"), std::string::npos);
  for (const char* method : {"event_svgf", "svgf", "pt"}) {
    c = config(), c.method = method;
    EXPECT_NE(refinementFault(c).find(method), std::string::npos);
    EXPECT_NE(refinementFault(c).find("whole frames only"), std::string::npos);
  }
}

}  // namespace
}  // namespace saccade
