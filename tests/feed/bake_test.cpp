#include "feed/bake.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <stdexcept>

#include "feed/bake_file.h"
#include "feed/room.h"

namespace saccade {
namespace {

using namespace std::chrono_literals;
using test::room;

constexpr int kW = 24, kH = 18;

Trajectory path() {
  return Trajectory({{0ms, Pose{{0, 0, -0.9}, {}}}, {200ms, Pose{{0.6, 0, -0.9}, {}}}});
}

FeedConfig config() {
  FeedConfig c;
  c.camera = pinhole(80, kW, kH), c.frame_rate_hz = 100, c.method = "irradiance_cache";
  c.spp = 1;
  std::string name;
  EXPECT_EQ(resolveParams(*findMethod(c.method), {}, c.params, name), "");
  return c;
}

BakePlan plan(float error = 0.2f) {
  return planBake(*room(), path(), config(), 20, error);
}

struct BakeTest : testing::Test {
  BakeTest() { std::filesystem::remove_all(folder); }
  Bake make(
      const BakePlan& plan, const std::function<void(const Baker&)>& after_pass = [](const Baker&) {}) {
    return bake(room(), plan, folder, pool, after_pass,
                [this](const std::string& fault) { faults.push_back(fault); });
  }
  std::vector<std::string> faults;  // of files
  TilePool pool{2};
  const std::string folder =
      testing::TempDir() + "saccade-" + testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(BakeTest, PosesAreSomePixelsApart) {
  EXPECT_GT(plan().poses.size(), 2u);
  EXPECT_LT(plan().poses.size(), 20u);
  EXPECT_EQ(plan().poses.front(), path().at(0ms));
  EXPECT_EQ(plan().poses.back(), path().at(200ms));
}

TEST_F(BakeTest, ItsPlanHasADigestThatCoversAll) {
  const auto scene = room();
  std::vector<std::uint64_t> digests{digestOf(*scene, plan())};
  const auto add = [&](const auto& change) {
    BakePlan other = plan();
    change(other);
    digests.push_back(digestOf(*scene, other));
  };
  add([](BakePlan& p) { p.poses.pop_back(); });
  add([](BakePlan& p) { p.poses.back().position.x += 1e-9; });
  add([](BakePlan& p) { ++p.camera.width; });
  add([](BakePlan& p) { ++p.camera.height; });
  add([](BakePlan& p) { p.camera.fx += 1e-9; });
  add([](BakePlan& p) { ++p.bounces; });
  add([](BakePlan& p) { p.channels = p.channels == 1 ? 3 : 1; });
  add([](BakePlan& p) { p.error += 1e-3f; });
  add([](BakePlan& p) { ++p.memory; });
  digests.push_back(digestOf(RenderScene(test::furnace(0.6f, 0)), plan()));
  for (std::size_t i = 0; i < digests.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) EXPECT_NE(digests[i], digests[k]) << i << " " << k;
}

TEST_F(BakeTest, RefusesLightThatChanges) {
  const auto flickering = room(Strength({{0ms, 1}, {50ms, 0}}));
  EXPECT_THROW(planBake(*flickering, path(), config(), 20, 0.2), std::runtime_error);
}

TEST_F(BakeTest, RefusesObjectsThatMove) {
  FeedConfig moving = config();
  moving.body_paths = {path()};
  try {
    planBake(*room(), path(), moving, 20, 0.2);
    FAIL();
  } catch (const std::runtime_error& fault) {
    EXPECT_NE(std::string(fault.what()).find("leave out the bake"), std::string::npos) << fault.what();
  }
}

// A bake is a cache. Each damage leads to the same bake as no file.
TEST_F(BakeTest, AFileThatCannotBeUsedIsSetAsideAndMadeAnew) {
  namespace fs = std::filesystem;
  const std::uint64_t digest = digestOf(*room(), plan());
  const std::string path = bakePath(folder, digest);
  const Bake made = make(plan());
  EXPECT_TRUE(faults.empty());
  const std::string kept = path + ".kept";
  fs::copy_file(path, kept);
  const auto size = fs::file_size(path);
  const std::vector<std::function<void()>> damages{
      [&] { writeBake(path, digest, "no state of a Baker"); },
      [&] { fs::resize_file(path, 0); },
      [&] { fs::resize_file(path, size - 1); },
      [&] { fs::resize_file(path, 0), fs::resize_file(path, size); },
      [&] { fs::remove(path), fs::create_directory(path); },
      [&] { fs::remove(path), mkfifo(path.c_str(), 0600); },
      [&] { fs::remove(path), fs::create_symlink("/dev/zero", path); },
  };
  for (const auto& damage : damages) {
    fs::remove_all(path);
    fs::copy_file(kept, path);
    damage();
    faults.clear();
    EXPECT_EQ(make(plan()).digest, made.digest);
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_TRUE(faults[0].starts_with(path + ": ")) << faults[0];
    EXPECT_TRUE(faults[0].ends_with("; it is now " + path + ".damaged, and is made anew")) << faults[0];
    EXPECT_TRUE(fs::exists(fs::symlink_status(path + ".damaged")));
    faults.clear();
    make(plan(), [](const Baker&) { FAIL() << "it makes a pass"; });
    EXPECT_TRUE(faults.empty());
  }
}

TEST_F(BakeTest, EndsWhenItsErrorIsReached) {
  const Bake coarse = make(plan(0.5f)), fine = make(plan(0.02f));
  EXPECT_GE(coarse.known, 0.99);
  EXPECT_GE(fine.known, 0.99);
  EXPECT_GT(fine.passes, coarse.passes);
  EXPECT_EQ(fine.poses, plan().poses.size());
  EXPECT_GT(fine.light->vertices(), 1000u);
}

TEST_F(BakeTest, IsTakenFromItsFile) {
  const Bake made = make(plan());
  const Bake kept = make(plan(), [](const Baker&) { FAIL() << "it makes a pass"; });
  EXPECT_EQ(kept.digest, made.digest);
  EXPECT_EQ(kept.known, made.known);
  EXPECT_EQ(kept.light->vertices(), made.light->vertices());
}

struct Stopped {};

TEST_F(BakeTest, GoesOnWhereItWasStoppedWithTheSameBytes) {
  int passes = 0;
  double share = 0;
  const auto stop = [&](const Baker& baker) {
    EXPECT_GE(baker.share(), share);
    share = baker.share(), ++passes;
    throw Stopped{};
  };
  EXPECT_THROW(make(plan(), stop), Stopped);
  EXPECT_THROW(make(plan(), stop), Stopped);
  EXPECT_EQ(passes, 2);
  const Bake resumed = make(plan(), [&](const Baker&) { ++passes; });
  EXPECT_EQ(resumed.passes, passes);
  std::filesystem::remove_all(folder);
  EXPECT_EQ(make(plan()).digest, resumed.digest);
}

TEST_F(BakeTest, IsTheSameForAnyNumberOfThreads) {
  Baker one(room(), plan()), three(room(), plan());
  TilePool one_thread(1), three_threads(3);
  for (int i = 0; i < 3; ++i) one.pass(one_thread), three.pass(three_threads);
  EXPECT_EQ(one.state(), three.state());
}

// It covers the first poses, and tells how many.
TEST_F(BakeTest, KeepsToItsMemory) {
  FeedConfig large = config();
  large.camera = pinhole(80, 96, 72);
  BakePlan small = planBake(*room(), path(), large, 20, 0.2);
  small.memory = 8;
  Baker baker(room(), small);
  baker.pass(pool);
  EXPECT_GE(baker.poses(), 1u);
  EXPECT_LT(baker.poses(), small.poses.size());
  while (!baker.isDone()) baker.pass(pool);
  EXPECT_LT(baker.state().size(), 8u << 20);
  const Bake made = make(small);
  EXPECT_EQ(made.poses, baker.poses());
  EXPECT_EQ(made.full, baker.isFull());
}

// Where memory does not suffice for cells of half the size, a bake that was interrupted keeps to the others.
TEST_F(BakeTest, ResumesWithTheCellsThatItHad) {
  BakePlan small = plan();
  small.memory = 2;
  Baker whole(room(), small), interrupted(room(), small), resumed(room(), small);
  whole.pass(pool), interrupted.pass(pool);
  resumed.restore(interrupted.state());
  whole.pass(pool), resumed.pass(pool);
  EXPECT_EQ(resumed.state(), whole.state());
}

TEST_F(BakeTest, GoesOnWithWhatItHasWhenMemoryIsFull) {
  BakePlan small = plan(0.05f);
  small.camera = pinhole(80, 48, 36), small.memory = 1;
  Baker baker(room(), small);
  while (!baker.isFull() && !baker.isDone()) baker.pass(pool);
  ASSERT_TRUE(baker.isFull());
  ASSERT_FALSE(baker.isDone());
  const std::size_t vertices = baker.vertices();
  EXPECT_LT(baker.known(), 0.99);
  while (!baker.isDone()) baker.pass(pool);
  EXPECT_EQ(baker.vertices(), vertices);
  EXPECT_GE(baker.known(), 0.99);
}

// The pixels of the current frame that get paths.
int tracedBy(const Feed& feed) {
  int traced = 0;
  for (int y = 0; y < kH; ++y)
    for (const SurfacePoint& p : feed.frames().cur.surfaces->row(y)) traced += p.paths > 0;
  return traced;
}

TEST_F(BakeTest, AFeedThatHasOneTracesHardlyAnyPath) {
  FeedConfig with = config();
  with.baked = make(plan()).light;
  Feed feed(room(), path(), with, pool);
  for (int t = 0; t < 5; ++t) feed.step(pool);
  EXPECT_LT(tracedBy(feed), kW * kH / 20);
  for (int x = 0; x < kW; ++x) EXPECT_GT(feed.change().I_now.at(x, kH / 2), 0);
}

// A camera that looks between the pixels of the bake's only pose.
TEST_F(BakeTest, ReachesAllVerticesThatPixelsLieBetween) {
  BakePlan one = plan();
  one.poses.resize(1);
  FeedConfig with = config();
  with.baked = make(one).light;
  constexpr double kHalfPixel = 0.035;  // rad
  const Pose aside{one.poses[0].position, axisAngle({kHalfPixel, kHalfPixel, 0})};
  const Feed feed(room(), Trajectory({{0ms, aside}}), with, pool);
  EXPECT_LT(tracedBy(feed), kW * kH / 8);
}

TEST_F(BakeTest, FeedsThatShareItAreTheSameForAnyNumberOfThreads) {
  FeedConfig with = config();
  with.baked = make(plan()).light;
  TilePool one(1), three(3);
  Feed a(room(), path(), with, one), b(room(), path(), with, three);
  for (int t = 0; t < 5; ++t) {
    const IntensityChange &x = a.step(one), &y = b.step(three);
    for (int row = 0; row < kH; ++row)
      for (int column = 0; column < kW; ++column) {
        ASSERT_EQ(x.dI.at(column, row), y.dI.at(column, row));
        ASSERT_EQ(x.var_dI.at(column, row), y.var_dI.at(column, row));
      }
  }
}

// Beyond the frames that it covers, a feed learns as without it.
TEST_F(BakeTest, AFeedLearnsTheRestOnItsOwn) {
  FeedConfig with = config();
  BakePlan start = plan();
  start.poses.resize(1);
  with.baked = make(start).light;
  const Trajectory turn({{0ms, path().at(0ms)}, {100ms, Pose{{0, 0, -0.9}, axisAngle({0, 1.5, 0})}}});
  Feed feed(room(), turn, with, pool);
  for (int t = 0; t < 15; ++t) feed.step(pool);
  const IntensityChange& change = feed.change();
  for (int y = 0; y < kH; ++y)
    for (int x = 0; x < kW; ++x) {
      ASSERT_TRUE(std::isfinite(change.I_now.at(x, y)));
      ASSERT_GT(change.I_now.at(x, y), 0);
    }
}

}  // namespace
}  // namespace saccade
