// Paths that are reconnected to what their pixel shows in the other frame: against independent pictures of
// both frames, and against replay.
#include <gtest/gtest.h>

#include <numeric>

#include "render/moving_room.h"
#include "render/render_mean.h"

namespace saccade {
namespace {

constexpr int kSize = 8, kSpp = 32;
constexpr FrameIndex kFrame = 5;
constexpr double kStep = 0.04;  // of the camera between both frames, to the right
using Seeds = SeedPlan (*)(std::uint64_t, FrameIndex, int);

Frame render(const PosedScene& now, const PosedScene& before, double x_now, double x_before,
             const SeedPlan& seeds, bool stands = false) {
  TilePool pool(2);
  Frame frame(kSize, kSize);
  frame.stands = stands;
  const auto cameraAt = [&](double x) {
    return Camera(now.still().description().T_world_camera * Pose{{x, 0, 0}, {}}, pinhole(80, kSize, kSize));
  };
  const Camera camera = cameraAt(x_now), prev = cameraAt(x_before);
  Renderer({2, 1}).render(PixelContext({now, camera}, {before, prev}), seeds, pool, frame);
  return frame;
}

// The means of dI over many seeds, and their variances.
struct Differences {
  std::array<double, kSize * kSize> mean{}, variance{};

  double noise() const { return std::accumulate(variance.begin(), variance.end(), 0.); }
};
template <class F>
Differences meanOver(int repeats, const F& sample) {
  Differences d;
  for (int r = 0; r < repeats; ++r) {
    const auto [now, before] = sample(static_cast<std::uint64_t>(r));
    for (int i = 0; i < kSize * kSize; ++i) {
      const double dI = now.at(i % kSize, i / kSize) - before.at(i % kSize, i / kSize);
      d.mean[i] += dI, d.variance[i] += dI * dI;
    }
  }
  for (int i = 0; i < kSize * kSize; ++i) {
    d.mean[i] /= repeats;
    d.variance[i] = (d.variance[i] / repeats - d.mean[i] * d.mean[i]) / (repeats - 1);
  }
  return d;
}

// As pt-correlated has it: pass 1 of a frame, less pass 2 of the frame before.
Differences correlated(const Scene& scene, Seeds seeds, int repeats) {
  const PosedScene posed(std::make_shared<RenderScene>(scene));
  return meanOver(repeats, [&](std::uint64_t seed) {
    return std::pair(render(posed, posed, kStep, 0, seeds(seed, kFrame, kSpp)).samples.I1,
                     render(posed, posed, 0, -kStep, seeds(seed, kFrame - 1, kSpp)).samples.I2);
  });
}
Differences independent(const Scene& scene, int repeats) {
  const PosedScene posed(std::make_shared<RenderScene>(scene));
  return meanOver(repeats, [&](std::uint64_t seed) {
    const auto picture = [&](double x, FrameIndex t) {
      return render(posed, posed, x, x, SeedPlan::independent(seed + 1000, t, 16 * kSpp)).samples.I2;
    };
    return std::pair(picture(kStep, 1), picture(0, 0));
  });
}

double largestDifference(const ImageF& a, const ImageF& b) {
  double largest = 0;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) largest = std::max<double>(largest, std::abs(a.at(x, y) - b.at(x, y)));
  return largest;
}

Scene roomWithMirrors(std::initializer_list<std::size_t> walls) {
  Scene s = test::movingRoom();
  s.materials.push_back(test::grey(0.6f));
  s.materials.back().model.kind = BsdfKind::kConductor;
  for (const std::size_t wall : walls) s.meshes[wall].material = 1;
  return s;
}

void expectEqualMeans(const Scene& scene) {
  const Differences a = correlated(scene, SeedPlan::reconnected, 400), b = independent(scene, 100);
  double squares = 0, sum = 0, variance = 0;
  for (std::size_t i = 0; i < a.mean.size(); ++i) {
    const double error = a.mean[i] - b.mean[i], v = a.variance[i] + b.variance[i];
    squares += error * error / v, sum += error, variance += v;
  }
  const double n = kSize * kSize;
  EXPECT_LT(squares, n + 4 * std::sqrt(2 * n));
  EXPECT_LT(std::abs(sum), 4 * std::sqrt(variance));
}

TEST(Reconnection, HasTheMeanOfIndependentPictures) {
  expectEqualMeans(test::movingRoom());
  expectEqualMeans(roomWithMirrors({0, 2}));
}

TEST(Reconnection, HasLessNoiseThanReplayBetweenDiffuseWalls) {
  const double ratio = correlated(test::movingRoom(), SeedPlan::reconnected, 50).noise() /
                       correlated(test::movingRoom(), SeedPlan::correlated, 50).noise();
  EXPECT_LT(ratio, 0.7);
}

// Pass 2 traces the paths of replay, in two parts.
TEST(Reconnection, KeepsThePathsOfPassTwo) {
  const PosedScene posed(std::make_shared<RenderScene>(test::movingRoom()));
  const auto passTwo = [&](Seeds seeds) {
    return render(posed, posed, kStep, 0, seeds(7, kFrame, kSpp)).samples.I2;
  };
  EXPECT_LT(largestDifference(passTwo(SeedPlan::reconnected), passTwo(SeedPlan::correlated)), 1e-4);
}

TEST(Reconnection, LeavesNoDifferenceWhereAllStands) {
  for (const Scene& scene : {test::movingRoom(), roomWithMirrors({0, 2})}) {
    const PosedScene posed(std::make_shared<RenderScene>(scene));
    const Frame before = render(posed, posed, kStep, 0, SeedPlan::reconnected(7, kFrame - 1, kSpp));
    const Frame now = render(posed, posed, kStep, kStep, SeedPlan::reconnected(7, kFrame, kSpp), true);
    EXPECT_EQ(largestDifference(now.samples.I1, before.samples.I2), 0);
  }
}

// All but the wall in view are mirrors, and a body that moves changes the light.
TEST(Reconnection, ReplaysWhatItCannotConnect) {
  const auto body = test::withBodies({"ball"});
  const Body& ball = body->description().bodies[0];
  const PosedScene moved(body, {test::standing(ball, test::kMoved)}), unmoved(body, {test::standing(ball)});
  Scene all_mirrors = roomWithMirrors({0, 1, 2, 3, 4, 6, 7});
  all_mirrors.spheres[0].material = 1;
  const PosedScene mirrors(std::make_shared<RenderScene>(all_mirrors));
  const auto passOne = [](const PosedScene& now, const PosedScene& before, Seeds seeds) {
    return render(now, before, kStep, 0, seeds(7, kFrame, kSpp)).samples.I1;
  };
  for (const auto& [now, before] : {std::pair(&moved, &unmoved), std::pair(&mirrors, &mirrors)}) {
    const ImageF replayed = passOne(*now, *before, SeedPlan::correlated);
    EXPECT_LT(largestDifference(passOne(*now, *before, SeedPlan::reconnected), replayed), 1e-4);
  }
  const ImageF replayed = passOne(unmoved, unmoved, SeedPlan::correlated);
  EXPECT_GT(largestDifference(passOne(unmoved, unmoved, SeedPlan::reconnected), replayed), 1e-3);
}

}  // namespace
}  // namespace saccade
