#include "methods/learned_denoiser.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "filter/synthetic.h"
#include "methods/optional_method.h"

namespace saccade {
namespace {

constexpr int kW = 48, kH = 32;

// Answers 2 I, and rubbish in three pixels.
class Doubling : public PictureDenoiser {
 public:
  void denoise(const Frame& frame, ImageF& I) override {
    for (int y = 0; y < kH; ++y)
      for (int x = 0; x < kW; ++x) I.at(x, y) = 2 * frame.samples.I2.at(x, y);
    I.at(0, 0) = std::numeric_limits<float>::quiet_NaN();
    I.at(1, 0) = std::numeric_limits<float>::infinity();
    I.at(2, 0) = -1;
  }
};

// A standing wall of random samples of mean 1, fresh in every frame.
struct Walls {
  Walls() {
    for (Frame* frame : {&a, &b}) {
      test::makeWall(*frame);
      frame->samples.spp1 = 0, frame->samples.spp2 = 2;
    }
    test::fillRandom(a.samples.I2, 1, 0.5f, 1.5f);
    test::fillRandom(b.samples.I2, 2, 0.5f, 1.5f);
  }
  IntensityChange change(Method& method, int threads) {
    TilePool pool(threads);
    IntensityChange out(kW, kH);
    StageTimes times;
    method.start(a, pool);
    method.estimate({b, a}, pool, out, times);
    EXPECT_GT(times.total().count(), 0);
    return out;
  }
  Frame a{kW, kH}, b{kW, kH};
};

TEST(LearnedDenoiser, ChangeIsTheDifferenceOfTwoDenoisedFrames) {
  Walls walls;
  LearnedDenoiser method(std::make_unique<Doubling>(), kW, kH);
  const IntensityChange change = walls.change(method, 2);
  for (int y = 1; y < kH; ++y) {
    for (int x = 0; x < kW; ++x) {
      ASSERT_EQ(change.I_prev.at(x, y), 2 * walls.a.samples.I2.at(x, y));
      ASSERT_EQ(change.I_now.at(x, y), 2 * walls.b.samples.I2.at(x, y));
      ASSERT_EQ(change.dI.at(x, y), change.I_now.at(x, y) - change.I_prev.at(x, y));
    }
  }
  for (int x = 0; x < 3; ++x) {
    EXPECT_EQ(change.I_now.at(x, 0), 0);
    EXPECT_EQ(change.dI.at(x, 0), 0);
  }
}

// A method of the table, or nullptr where the table lacks it.
std::unique_ptr<Method> optional(const std::string& name) {
  const MethodInfo* info = findMethod(name);
  return info ? info->make({{}, kW, kH, 2}) : nullptr;
}

double rmsAround(const ImageF& plane, float mean) {
  double sum = 0;
  for (int y = 5; y < kH - 5; ++y)
    for (int x = 5; x < kW - 5; ++x) sum += std::pow(plane.at(x, y) - mean, 2.0);
  return std::sqrt(sum / ((kW - 10) * (kH - 10)));
}

class Network : public ::testing::TestWithParam<const char*> {};

// A uniform sample in [0.5, 1.5) has a standard deviation of 1 / sqrt(12).
TEST_P(Network, CleansAWallAlikeForAnyNumberOfThreads) {
  const auto method = optional(GetParam()), again = optional(GetParam());
  if (!method) GTEST_SKIP() << noMethod(GetParam());
  Walls walls;
  const IntensityChange one = walls.change(*method, 1), three = walls.change(*again, 3);
  EXPECT_LT(rmsAround(one.I_now, 1), 0.5 / std::sqrt(12.0));
  EXPECT_GT(rmsAround(one.dI, 0), 0);  // each frame by itself: a standing wall goes on changing
  for (int y = 0; y < kH; ++y)
    for (int x = 0; x < kW; ++x) ASSERT_EQ(one.dI.at(x, y), three.dI.at(x, y));
}

// Samples that overflowed, and surfaces without a normal, leave the rest of the picture alone.
TEST_P(Network, RubbishStaysFinite) {
  const auto method = optional(GetParam());
  if (!method) GTEST_SKIP() << noMethod(GetParam());
  Walls walls;
  walls.b.samples.I2.at(20, 10) = std::numeric_limits<float>::quiet_NaN();
  walls.b.samples.I2.at(21, 10) = std::numeric_limits<float>::infinity();
  walls.b.samples.I2.at(22, 10) = -1e30f;
  test::fillInside(walls.b.g.nz, 0);
  test::fillInside(walls.b.g.albedo, 0);
  walls.b.g.z.fill(kMissDepth);
  const IntensityChange change = walls.change(*method, 1);
  for (int y = 0; y < kH; ++y)
    for (int x = 0; x < kW; ++x) ASSERT_TRUE(std::isfinite(change.dI.at(x, y))) << x << "," << y;
}

TEST_P(Network, IsOfferedOnlyWhereItIsAndElseSaysWhatIsMissing) {
  const std::string name = GetParam();
  if (findMethod(name)) {
    EXPECT_NE(methodNames().find(name), std::string::npos);
    return;
  }
  EXPECT_EQ(methodNames().find(name), std::string::npos);
  const std::string fault = noMethod(name), start = "there is no method '" + name + "' here: ";
  EXPECT_EQ(fault.substr(0, start.size()), start);
  EXPECT_TRUE(fault.find("install") != std::string::npos ||
              fault.find("SACCADE_LEARNED_MODEL must name") != std::string::npos)
      << fault;
}

INSTANTIATE_TEST_SUITE_P(Methods, Network, ::testing::Values("oidn", "learned"),
                         [](const auto& test) { return std::string(test.param); });

TEST(NoMethod, NamesTheOthers) {
  EXPECT_EQ(noMethod("magic"), "there is no method 'magic'; there are: " + methodNames());
  EXPECT_LT(noMethod(std::string(10000, 'x')).size(), 1000);
}

}  // namespace
}  // namespace saccade
