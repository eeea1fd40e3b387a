#include "filter/demodulation.h"

#include <gtest/gtest.h>

#include <limits>

#include "filter/synthetic.h"

namespace saccade {
namespace {

using test::fillRandom;
constexpr int kW = 33, kH = 17;

struct Fixture : ::testing::Test {
  Fixture() {
    for (Frame* f : {&cur, &prev}) {
      const std::uint64_t s = f == &cur ? 1 : 100;
      f->samples.spp1 = f->samples.spp2 = 1;
      fillRandom(f->g.albedo, s, 0.05f, 1);
      fillRandom(f->g.emission, s + 1);
      fillRandom(f->samples.I1, s + 2, 1, 3);
      fillRandom(f->samples.I2, s + 3, 1, 3);
    }
  }
  TilePool pool{1};
  Frame cur{kW, kH}, prev{kW, kH};
  IlluminationSamples samples{kW, kH}, samples_prev{kW, kH};
  FilterPlanes filtered{kW, kH};
  ImageF zero{kW, kH};
  IntensityChange change{kW, kH};
};

// Eq. 19 is an identity: with D the identity it gives back I_t - I_{t-1} for any albedos and emissions.
TEST_F(Fixture, ModulationUndoesDemodulation) {
  demodulate(FramePair::first(prev), Demodulation::kAlbedo, pool, samples_prev);
  demodulate({cur, prev}, Demodulation::kAlbedo, pool, samples);
  for (int y = 0; y < kH; ++y) {
    for (int x = 0; x < kW; ++x) filtered.d.at(x, y) = samples.i.at(x, y) - samples_prev.i.at(x, y);
  }
  filtered.i.copyFrom(samples.i);
  modulate({cur, prev}, Demodulation::kAlbedo, 1, filtered, samples_prev.i, zero, pool, change);
  for (int y = 0; y < kH; ++y) {
    for (int x = 0; x < kW; ++x) {
      const float I = (cur.samples.I1.at(x, y) + cur.samples.I2.at(x, y)) / 2;
      const float I_prev = (prev.samples.I1.at(x, y) + prev.samples.I2.at(x, y)) / 2;
      EXPECT_NEAR(change.dI.at(x, y), I - I_prev, 2e-5f);
      EXPECT_NEAR(change.I_prev.at(x, y), I_prev, 1e-5f);
      EXPECT_NEAR(change.I_now.at(x, y), I, 1e-5f);
    }
  }
}

TEST_F(Fixture, DifferenceIsOfThePassesThatShareSeeds) {
  demodulate({cur, prev}, Demodulation::kAlbedo, pool, samples);
  const float expected = (cur.samples.I1.at(4, 5) - cur.g.emission.at(4, 5)) / cur.g.albedo.at(4, 5) -
                         (prev.samples.I2.at(4, 5) - prev.g.emission.at(4, 5)) / prev.g.albedo.at(4, 5);
  EXPECT_NEAR(samples.d.at(4, 5), expected, 1e-5f);
  demodulate(FramePair::first(cur), Demodulation::kAlbedo, pool, samples);
  EXPECT_EQ(samples.d.at(4, 5), 0);  // the first frame has none
}

TEST_F(Fixture, BlackAlbedoAndBadSamplesStayFinite) {
  cur.g.albedo.at(1, 1) = 0;
  cur.samples.I1.at(2, 1) = std::numeric_limits<float>::quiet_NaN();
  cur.samples.I1.at(3, 1) = std::numeric_limits<float>::infinity();
  cur.samples.I1.at(4, 1) = 1e30f;  // finite, but not its square: a moment of infinity would stay for good
  demodulate({cur, prev}, Demodulation::kAlbedo, pool, samples);
  for (int x : {1, 2, 3, 4}) {
    EXPECT_TRUE(std::isfinite(samples.i.at(x, 1) * samples.i.at(x, 1))) << x;
    EXPECT_TRUE(std::isfinite(samples.d.at(x, 1) * samples.d.at(x, 1))) << x;
  }
}

// A black pixel shows what it emits, though the filter brings it its neighbours' light.
TEST_F(Fixture, BlackReflectsNoneOfTheLightThatTheFilterSpills) {
  cur.g.albedo.at(1, 1) = prev.g.albedo.at(1, 1) = 0;  // stays black
  cur.g.albedo.at(2, 1) = 0;                           // turns black
  const float E = cur.g.emission.at(2, 1), I_prev = 0.5f * prev.g.albedo.at(2, 1) + prev.g.emission.at(2, 1);
  for (ImageF* plane : {&filtered.i, &filtered.d}) test::fillInside(*plane, 3);
  ImageF i_prev(kW, kH);
  test::fillInside(i_prev, 0.5f);
  modulate({cur, prev}, Demodulation::kAlbedo, 1, filtered, i_prev, zero, pool, change);
  EXPECT_EQ(change.dI.at(1, 1), cur.g.emission.at(1, 1) - prev.g.emission.at(1, 1));
  EXPECT_EQ(change.I_prev.at(1, 1), prev.g.emission.at(1, 1));
  EXPECT_EQ(change.I_now.at(1, 1), cur.g.emission.at(1, 1));
  EXPECT_NEAR(change.dI.at(2, 1), E - I_prev, 1e-6f);
}

TEST(FilterAlbedo, IsFlooredRoundedOrIgnored) {
  EXPECT_EQ(filterAlbedo(0.3f, Demodulation::kAlbedo), 0.3f);
  EXPECT_EQ(filterAlbedo(0, Demodulation::kAlbedo), 1e-3f);
  EXPECT_FLOAT_EQ(filterAlbedo(0.3f, Demodulation::kEightBits), 77 / 255.f);
  EXPECT_EQ(filterAlbedo(0.3f, Demodulation::kNone), 1);
  EXPECT_EQ(modulationAlbedo(1e-6f, Demodulation::kAlbedo), 1e-3f);
  EXPECT_EQ(modulationAlbedo(0, Demodulation::kAlbedo), 0);
  EXPECT_EQ(modulationAlbedo(0, Demodulation::kEightBits), 1e-3f);  // Falcor's
}

}  // namespace
}  // namespace saccade
