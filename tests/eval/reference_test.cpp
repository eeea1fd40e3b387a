#include "eval/bench/reference.h"

#include <filesystem>
#include <fstream>
#include <functional>

#include "eval/metrics/for_each_pixel.h"
#include "eval/pictures/exr.h"
#include "render/test_scenes.h"
#include "scene/scratch.h"

namespace saccade::eval {
namespace {

using namespace std::chrono_literals;

constexpr int kW = 8, kH = 6;

struct Fixture : ::testing::Test {
  Scratch files;
  TilePool pool{2};
  Progress progress{"reference", 1};

  // A floor under a ball that emits light of this strength.
  std::shared_ptr<const RenderScene> scene(Strength strength) const {
    Scene s = test::floorFromAbove(0.6f);
    s.spheres.push_back({"ball", {0, 0, 0.8f}, 0.4f, 0, {5, 5, 5}, std::move(strength)});
    return std::make_shared<RenderScene>(std::move(s));
  }
  ReferenceRenderer renderer(std::shared_ptr<const RenderScene> scene, std::uint64_t seed = 0,
                             bool whole_pixel = false) {
    std::filesystem::create_directories(files.path("cache"));
    return {scene, {1, 1, whole_pixel}, kW, kH, 60, files.path("cache"), pool, seed};
  }
  ReferenceFrame render(int spp) {
    const auto steady = scene({});
    return renderer(steady).frame(steady->description().T_world_camera, 0ms, spp, progress);
  }
  // The only file.
  std::string keptFile() const {
    return std::filesystem::directory_iterator(files.path("cache"))->path().string();
  }
  long kept() const { return std::distance(std::filesystem::directory_iterator(files.path("cache")), {}); }
};

void expectEqual(const ReferenceFrame& x, const ReferenceFrame& y) {
  forEachPixel(x.a, [&](int column, int row) {
    ASSERT_EQ(x.a.at(column, row), y.a.at(column, row));
    ASSERT_EQ(x.b.at(column, row), y.b.at(column, row));
  });
}

TEST(ReferenceChange, ByHand) {
  ReferenceFrame prev(1, 1), cur(1, 1);
  prev.a.fill(1), prev.b.fill(2), cur.a.fill(4), cur.b.fill(3);
  const ReferenceChange truth(prev, cur);
  EXPECT_EQ(truth.half_a.at(0, 0), 3);
  EXPECT_EQ(truth.half_b.at(0, 0), 1);
  EXPECT_EQ(truth.prev_a.at(0, 0), 1);
  EXPECT_EQ(truth.prev_b.at(0, 0), 2);
  EXPECT_EQ(truth.change.dI.at(0, 0), 2);
  EXPECT_EQ(truth.change.I_prev.at(0, 0), 1.5);
  EXPECT_EQ(truth.change.I_now.at(0, 0), 3.5);
  // The variance of two samples 3 and 1 is 2, and that of their mean is 1.
  EXPECT_EQ(truth.change.var_dI.at(0, 0), 1);
  EXPECT_EQ(truth.change.var_I_prev.at(0, 0), 0.25);
  EXPECT_EQ(truth.error(), 1);
}

// The errors of two references have equal signs at half of the pixels where they share nothing. They do at
// all of them where they share their seeds. Of 8 x 48 pixels, 0.5 to 0.63 are five standard deviations.
TEST_F(Fixture, ReferencesOfTwoSeedsAreIndependent) {
  const auto steady = scene({});
  for (const bool whole_pixel : {false, true}) {
    const auto frame = [&](std::uint64_t seed, int spp) {
      return renderer(steady, seed, whole_pixel)
          .frame(steady->description().T_world_camera, 0ms, spp, progress);
    };
    const ReferenceFrame truth = frame(99, 8192);
    expectEqual(frame(7, 64), frame(7, 64));
    double equal = 0, all = 0;
    for (std::uint64_t seed = 0; seed < 16; seed += 2) {
      const ReferenceFrame one = frame(seed, 64), other = frame(seed + 1, 64);
      forEachPixel(truth.a, [&](int x, int y) {
        const float at = truth.mean(x, y);
        equal += (one.mean(x, y) > at) == (other.mean(x, y) > at), all += 1;
      });
    }
    EXPECT_NEAR(equal / all, 0.5, 0.13) << "whole pixels: " << whole_pixel;
  }
}

TEST_F(Fixture, ShowsAndKeepsAFrameForEveryStrengthOfItsLamp) {
  const auto switched = scene(Strength({{0ms, 1}, {50ms, 1}, {50ms, 0.25f}}));
  const Pose pose = switched->description().T_world_camera;
  ReferenceRenderer reference = renderer(switched);
  const ReferenceFrame on = reference.frame(pose, 0ms, 64, progress);
  const ReferenceFrame off = reference.frame(pose, 50ms, 64, progress);
  EXPECT_EQ(kept(), 2);
  const ReferenceFrame still_on = reference.frame(pose, 20ms, 64, progress);
  EXPECT_EQ(kept(), 2);
  EXPECT_GT(on.a.at(0, 0), 0);
  for (int y = 0; y < kH; ++y) {
    for (int x = 0; x < kW; ++x) {
      ASSERT_EQ(off.a.at(x, y), 0.25f * on.a.at(x, y));
      ASSERT_EQ(off.b.at(x, y), 0.25f * on.b.at(x, y));
      ASSERT_EQ(still_on.a.at(x, y), on.a.at(x, y));
    }
  }
}

TEST_F(Fixture, TimeIsNothingToASceneThatStaysAsItIs) {
  const auto steady = scene({});
  const Pose pose = steady->description().T_world_camera;
  ReferenceRenderer reference = renderer(steady);
  reference.frame(pose, 0ms, 64, progress);
  reference.frame(pose, 50ms, 64, progress);
  EXPECT_EQ(kept(), 1);
}

TEST_F(Fixture, AFrameIsTakenFromTheCache) {
  render(64);
  ReferenceFrame other(kW, kH);
  other.b.at(3, 2) = 7;
  writeExr(keptFile(), {{"a", &other.a}, {"b", &other.b}}, {{"spp", 64}});
  expectEqual(render(64), other);
}

TEST_F(Fixture, AHalfFinishedFrameIsGoneOnWith) {
  const ReferenceFrame whole = render(128);
  const std::string path = keptFile();
  ReferenceFrame half = render(64);
  EXPECT_NE(half.b.at(3, 2), whole.b.at(3, 2));
  half.a.at(3, 2) += 64;  // to be known by
  writeExr(path, {{"a", &half.a}, {"b", &half.b}}, {{"spp", 64}});
  const ReferenceFrame gone_on = render(128);
  EXPECT_NEAR(gone_on.a.at(3, 2), whole.a.at(3, 2) + 32, 1e-4);
  EXPECT_NEAR(gone_on.b.at(3, 2), whole.b.at(3, 2), 1e-4);  // sums of another order
}

// Otherwise the difference of two frames would have the noise of the paths that only one of them has.
TEST_F(Fixture, FramesOfMorePathsAreKeptApart) {
  const ReferenceFrame few = render(64);
  std::filesystem::remove(keptFile());
  render(128);
  expectEqual(render(64), few);
}

TEST_F(Fixture, AFileThatIsNoSuchFrameIsRenderedAnew) {
  const ReferenceFrame frame = render(64);
  const std::string path = keptFile();
  const auto size = std::filesystem::file_size(path);
  const ImageF small(3, 2), other(kW, kH);
  const std::function<void()> spoilers[] = {
      [&] { std::filesystem::resize_file(path, size / 2); },
      [&] { std::ofstream(path) << "no picture"; },
      [&] {
        writeExr(path, {{"a", &other}, {"b", &other}});
      },
      [&] {
        writeExr(path, {{"Y", &other}}, {{"spp", 64}});
      },
      [&] {
        writeExr(path, {{"a", &small}, {"b", &small}}, {{"spp", 64}});
      },
  };
  for (const auto& spoil : spoilers) {
    spoil();
    expectEqual(render(64), frame);
    EXPECT_EQ(readExr(path).attributes.at("spp"), 64);
  }
}

}  // namespace
}  // namespace saccade::eval
