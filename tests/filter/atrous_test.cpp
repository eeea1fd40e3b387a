#include "filter/atrous.h"

#include <gtest/gtest.h>

#include "base/instruction_set.h"
#include "filter/edge_stopping.h"
#include "filter/synthetic.h"

namespace saccade {
namespace {

using test::fillInside;
using test::fillRandom;
constexpr int kW = 37, kH = 29;

// Random features: a bumpy slope, turned normals.
void makeBumps(Frame& frame, std::uint64_t seed) {
  GBuffer& g = frame.g;
  for (int y = 0; y < kH; ++y) {
    for (int x = 0; x < kW; ++x) {
      const float a = 0.1f * test::randomAt(seed, x, y), b = 0.1f * test::randomAt(seed + 1, x, y);
      g.nx.at(x, y) = std::sin(a) * std::cos(b);
      g.ny.at(x, y) = std::sin(a) * std::sin(b);
      g.nz.at(x, y) = -std::cos(a);
      g.z.at(x, y) = 5 + 0.02f * static_cast<float>(x) + 0.01f * test::randomAt(seed + 2, x, y);
      g.dz.at(x, y) = 0.02f;
    }
  }
}

struct Fixture : ::testing::Test {
  Fixture() {
    makeBumps(cur, 1);
    makeBumps(prev, 5);
    fillRandom(in.i, 10);
    fillRandom(in.var_i, 11, 0, 0.01f);
    fillRandom(in.d, 12, -0.1f, 0.1f);
    fillRandom(in.var_d, 13, 0, 1e-4f);
  }
  TilePool pool{2};
  Frame cur{kW, kH}, prev{kW, kH};
  FilterPlanes in{kW, kH}, out{kW, kH};
};

bool inside(int x, int y) {
  return x >= 0 && y >= 0 && x < kW && y < kH;
}

// 3x3 binomial mean of the variance; pixels outside repeat the edge.
double blurred(const ImageF& v, int x, int y) {
  double sum = 0;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      sum += v.at(std::clamp(x + dx, 0, kW - 1), std::clamp(y + dy, 0, kH - 1)) /
             (4.0 * (1 + dx * dx) * (1 + dy * dy));
    }
  }
  return sum;
}

// w_z w_n of one frame, as Eqs. 23 and 24 with Falcor's slope.
double featureWeight(const GBuffer& g, int x, int y, int qx, int qy) {
  const double cosine =
      g.nx.at(x, y) * g.nx.at(qx, qy) + g.ny.at(x, y) * g.ny.at(qx, qy) + g.nz.at(x, y) * g.nz.at(qx, qy);
  const double slope = g.dz.at(x, y) * std::hypot(qx - x, qy - y);
  return std::pow(std::max(0.0, cosine), 128) * std::exp(-std::abs(g.z.at(x, y) - g.z.at(qx, qy)) / slope);
}

struct Value {
  double signal, variance;
};

// Eqs. 3, 4, 12 and 25, pixel by pixel.
Value plainFilter(const Frame& cur, const Frame* prev, const ImageF& c, const ImageF& v, int x, int y,
                  int step) {
  const double h[3] = {1, 2.0 / 3, 1.0 / 6};
  const double tolerance = 10 * std::sqrt(blurred(v, x, y) + 1e-10);
  double w_sum = 0, c_sum = 0, v_sum = 0;
  for (int dy = -2; dy <= 2; ++dy) {
    for (int dx = -2; dx <= 2; ++dx) {
      const int qx = x + dx * step, qy = y + dy * step;
      if (!inside(qx, qy)) continue;
      double w =
          h[std::abs(dx)] * h[std::abs(dy)] * std::exp(-std::abs(c.at(x, y) - c.at(qx, qy)) / tolerance);
      if (dx != 0 || dy != 0) {
        w *= featureWeight(cur.g, x, y, qx, qy) * (prev ? featureWeight(prev->g, x, y, qx, qy) : 1);
      }
      w_sum += w, c_sum += w * c.at(qx, qy), v_sum += w * w * v.at(qx, qy);
    }
  }
  return {c_sum / w_sum, v_sum / (w_sum * w_sum)};
}

TEST_F(Fixture, EqualsThePapersFormulasPixelByPixel) {
  for (int step : {1, 2, 8}) {
    atrousIteration({cur, prev}, {}, step, in, pool, out);
    for (int y = 0; y < kH; ++y) {
      for (int x = 0; x < kW; ++x) {
        const Value i = plainFilter(cur, nullptr, in.i, in.var_i, x, y, step);
        const Value d = plainFilter(cur, &prev, in.d, in.var_d, x, y, step);
        // pow(n.n', 128) and exp2 are approximated: a percent of the signal's spread.
        ASSERT_NEAR(out.i.at(x, y), i.signal, 0.01) << x << "," << y << " step " << step;
        ASSERT_NEAR(out.var_i.at(x, y), i.variance, 0.03 * i.variance + 1e-6);
        ASSERT_NEAR(out.d.at(x, y), d.signal, 0.002);
        ASSERT_NEAR(out.var_d.at(x, y), d.variance, 0.03 * d.variance + 1e-8);
      }
    }
  }
}

TEST_F(Fixture, LeavesAConstantPictureAlone) {
  fillInside(in.i, 0.7f);
  fillInside(in.d, -0.2f);
  for (int step : {1, 16}) {
    atrousIteration({cur, prev}, {}, step, in, pool, out);
    for (int y = 0; y < kH; ++y) {
      for (int x = 0; x < kW; ++x) {
        ASSERT_NEAR(out.i.at(x, y), 0.7f, 1e-6f);
        ASSERT_NEAR(out.d.at(x, y), -0.2f, 1e-6f);
        ASSERT_LE(out.var_i.at(x, y), 0.0101f);
      }
    }
  }
}

TEST_F(Fixture, ThePrimalIsTheSameWithAndWithoutTheDifference) {
  atrousIteration({cur, prev}, {}, 2, in, pool, out);
  FilterPlanes alone(kW, kH);
  atrousIteration({cur, prev}, {.difference = false}, 2, in, pool, alone);
  for (int y = 0; y < kH; ++y) {
    for (int x = 0; x < kW; ++x) {
      ASSERT_EQ(alone.i.at(x, y), out.i.at(x, y));
      ASSERT_EQ(alone.var_i.at(x, y), out.var_i.at(x, y));
    }
  }
  EXPECT_EQ(alone.d.at(5, 5), 0);
}

TEST_F(Fixture, TheDifferenceIsTheSameWithAndWithoutThePrimal) {
  for (const bool use_prev : {false, true}) {
    FilterPlanes both(kW, kH), alone(kW, kH);
    atrousIteration({cur, prev}, {.use_prev = use_prev}, 2, in, pool, both);
    atrousIteration({cur, prev}, {.primal = false, .use_prev = use_prev}, 2, in, pool, alone);
    for (int y = 0; y < kH; ++y)
      for (int x = 0; x < kW; ++x) {
        EXPECT_EQ(alone.d.at(x, y), both.d.at(x, y));
        EXPECT_EQ(alone.var_d.at(x, y), both.var_d.at(x, y));
      }
  }
}

// Figure 3: an edge that only the previous frame saw must hold back the difference, not the primal.
TEST_F(Fixture, TheDifferenceHeedsEdgesOfThePreviousFrame) {
  for (Frame* f : {&cur, &prev}) test::makeWall(*f);
  for (int y = 0; y < kH; ++y) {
    for (int x = 0; x < kW; ++x) {
      if (x >= 18) prev.g.z.at(x, y) = 9;
      in.i.at(x, y) = in.d.at(x, y) = x >= 18 ? 1 : 0;
    }
  }
  fillInside(in.var_i, 100);  // the luminance term lets everything pass
  fillInside(in.var_d, 100);
  atrousIteration({cur, prev}, {}, 1, in, pool, out);
  EXPECT_GT(out.i.at(17, 10), 0.2f);
  EXPECT_LT(out.d.at(17, 10), 1e-6f);
  atrousIteration({cur, prev}, {.use_prev = false}, 1, in, pool, out);
  EXPECT_GT(out.d.at(17, 10), 0.2f);
}

TEST_F(Fixture, IsTheSameWithAnyLanes) {
  const std::string widest = instructionSetName();
  if (widest == "avx2") GTEST_SKIP() << "this processor has one set of instructions";
  FilterPlanes narrow(kW, kH);
  useInstructionSet("avx2");
  atrousIteration({cur, prev}, {}, 2, in, pool, narrow);
  useInstructionSet(widest);
  atrousIteration({cur, prev}, {}, 2, in, pool, out);
  for (const auto plane : {&FilterPlanes::i, &FilterPlanes::var_i, &FilterPlanes::d, &FilterPlanes::var_d})
    for (int y = 0; y < kH; ++y)
      for (int x = 0; x < kW; ++x)
        ASSERT_EQ((out.*plane).at(x, y), (narrow.*plane).at(x, y)) << x << ", " << y;
}

// RELAX's Gaussian, whose weights add up to 1 over 3x3 pixels.
TEST(SmallKernel, SpreadsAPixelOverItsNeighbours) {
  TilePool pool{1};
  Frame wall(kW, kH);
  test::makeWall(wall);
  FilterPlanes in(kW, kH), out(kW, kH);
  fillInside(in.var_i, 1);
  in.i.at(18, 14) = 1;
  const AtrousParams params{.sigma_l = 1000, .difference = false, .kernel = AtrousKernel::k3x3};
  constexpr int kStep = 2;
  constexpr float kWeights[] = {0.44198f, 0.27901f, 0};
  atrousIteration({wall, wall}, params, kStep, in, pool, out);
  for (int dy = 0; dy <= 2; ++dy) {
    for (int dx = 0; dx <= 2; ++dx) {
      const float expected = kWeights[dx] * kWeights[dy];
      EXPECT_NEAR(out.i.at(18 - kStep * dx, 14 + kStep * dy), expected, 0.01f * expected) << dx << "," << dy;
    }
  }
  EXPECT_EQ(out.i.at(17, 14), 0);
}

}  // namespace
}  // namespace saccade
