#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scene/sky/preetham_sky.h"
#include "scene/sky/sun.h"

namespace saccade {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kLumens = 683 * 106.857;  // of a luminance or an illuminance of 1, per area

// By the paper's formulas, worked out apart: 7.3204 kcd / m^2 and the chromaticity (0.24568, 0.25148). They
// hold for turbidity 3 and a sun at 45 degrees.
TEST(PreethamSky, TheZenithHasTheLuminanceAndTheColourOfThePaper) {
  const Rgb c = PreethamSky(3, 45 * kDegree).radiance(1, 45 * kDegree);
  EXPECT_NEAR(luminance(c) * kLumens, 7320.4, 8);
  const Vec3d xyz{0.4124 * c.x + 0.3576 * c.y + 0.1805 * c.z, 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z,
                  0.0193 * c.x + 0.1192 * c.y + 0.9505 * c.z};
  const double sum = xyz.x + xyz.y + xyz.z;
  EXPECT_NEAR(xyz.x / sum, 0.24568, 2e-4);
  EXPECT_NEAR(xyz.y / sum, 0.25148, 2e-4);
}

TEST(PreethamSky, OtherDirectionsFollowTheFormulaOfPerez) {
  const PreethamSky sky(3, 45 * kDegree);
  const double zenith = luminance(sky.radiance(1, 45 * kDegree));
  EXPECT_NEAR(luminance(sky.radiance(0.5, 105 * kDegree)) / zenith, 0.79732, 1e-3);
  EXPECT_NEAR(luminance(sky.radiance(0.5, 15 * kDegree)) / zenith, 2.96739, 4e-3);
}

TEST(PreethamSky, IsFiniteAndNowhereNegative) {
  for (const double turbidity : {kLeastTurbidity, 3.0, kMostTurbidity})
    for (const double sun : {0.0, 45.0, 89.9}) {
      const PreethamSky sky(turbidity, sun * kDegree);
      for (const double up : {-1.0, 0.0, 1e-6, 0.3, 1.0})
        for (const double from_sun : {0.0, 60.0, 180.0}) {
          const Rgb c = sky.radiance(up, from_sun * kDegree);
          EXPECT_TRUE(std::isfinite(dot(c, c)) && std::fmin(c.x, std::fmin(c.y, c.z)) >= 0);
          EXPECT_GT(luminance(c), 0);
        }
    }
}

// The example of the solar position algorithm of NREL (technical report TP-560-34302, A.5).
TEST(Sun, StandsWhereAnotherAlgorithmFindsIt) {
  const SunPlace place = sunPlace({2003, 10, 17, 12, 30, 30, 39.742476, -105.1786, -7});
  EXPECT_NEAR(place.zenith / kDegree, 50.11162, 0.04);  // there with refraction, of 0.02
  EXPECT_NEAR(place.azimuth / kDegree, 194.34024 - 360, 0.02);
}

// In clear air, the sun high above gives about 100 klx, and redder and less light where it is low.
TEST(Sun, GivesAsMuchLightAsInReality) {
  const Rgb high = sunIrradiance(2.5, 10 * kDegree), low = sunIrradiance(2.5, 85 * kDegree);
  EXPECT_NEAR(luminance(high) * kLumens, 100e3, 15e3);
  EXPECT_LT(luminance(low), 0.3f * luminance(high));
  EXPECT_GT(low.x / low.z, 2 * high.x / high.z);
  EXPECT_LT(luminance(sunIrradiance(8, 10 * kDegree)), luminance(high));
}

}  // namespace
}  // namespace saccade
