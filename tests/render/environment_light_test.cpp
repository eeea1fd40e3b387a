// Light from infinitely far away: look-up, and samples against their density.
#include "render/lights/environment_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "base/hash_rng.h"
#include "render/chi_square.h"

namespace saccade {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr float kUniform = static_cast<float>(1 / (4 * kPi));
constexpr float kLargest = 0x1.fffffep-1f;  // below 1

// As scene/light.h says, in the picture's own space: u, v in [0, 1] from the left and from the top.
Vec3 directionOf(double u, double v) {
  return toFloat({std::sin(kPi * v) * std::sin(2 * kPi * u), std::cos(kPi * v),
                  -std::sin(kPi * v) * std::cos(2 * kPi * u)});
}

Environment picture(int width, int height, std::vector<Rgb> pixels) {
  return {{1, 1, 1}, {width, height, std::move(pixels)}, {}};
}

// Of uncorrelated colours, a third of them black, with a lamp a hundred times as bright.
Environment noisy(int width, int height) {
  std::vector<Rgb> pixels;
  for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(width * height); ++i) {
    const auto u = [i](std::uint64_t c) { return toUnit(hashKey(c, i)); };
    pixels.push_back(u(0) < 0.33f ? Rgb{} : Rgb{u(1), u(2), u(3)});
  }
  pixels[pixels.size() / 3] = {90, 100, 40};
  return picture(width, height, std::move(pixels));
}

Environment turned(Environment e, const Affine& to_world) {
  e.to_world = to_world;
  return e;
}
constexpr Affine kOblique{{0.36, 0.48, -0.8}, {-0.8, 0.6, 0}, {0.48, 0.64, 0.6}, {}};
constexpr Affine kMirrored{{-0.36, -0.48, 0.8}, {-0.8, 0.6, 0}, {0.48, 0.64, 0.6}, {}};

struct Case {
  const char* name;
  Environment environment;
};

std::vector<Case> cases() {
  return {{"constant", {{0.2f, 0.5f, 0.1f}, {}, {}}},
          {"one pixel", picture(1, 1, {{0.3f, 0.2f, 0.1f}})},
          {"a column", noisy(1, 6)},
          {"a row", noisy(7, 1)},
          {"13x6", noisy(13, 6)},
          {"turned", turned(noisy(8, 5), kOblique)},
          {"mirrored", turned(noisy(8, 5), kMirrored)},
          {"a lamp in the dark",
           picture(4, 4, {{}, {}, {}, {}, {}, {}, {0, 0, 9}, {}, {}, {}, {}, {}, {}, {}, {}, {}})}};
}

// call(direction, solid angle) on a grid of the picture's space that no edge of a cell of up to 13x6 crosses.
template <class Call>
void forSphere(const Environment& e, Call call) {
  const int columns = 16 * std::max(1, e.picture.width), rows = 16 * std::max(1, e.picture.height);
  for (int j = 0; j < rows; ++j) {
    const double solid_angle =
        2 * kPi / columns * (std::cos(kPi * j / rows) - std::cos(kPi * (j + 1) / rows));
    for (int i = 0; i < columns; ++i) {
      const Vec3d d = toDouble(directionOf((i + 0.5) / columns, (j + 0.5) / rows));
      call(toFloat(mapVector(e.to_world, d)), solid_angle);
    }
  }
}

TEST(EnvironmentLight, PdfIntegratesTo1) {
  for (const Case& c : cases()) {
    const EnvironmentLight light(c.environment);
    double sum = 0;
    forSphere(c.environment, [&](Vec3 w, double solid_angle) { sum += light.pdf(w) * solid_angle; });
    EXPECT_NEAR(sum, 1, 1e-5) << c.name;
  }
}

TEST(EnvironmentLight, NoLightIsOutOfReach) {
  for (const Case& c : cases()) {
    const EnvironmentLight light(c.environment);
    forSphere(c.environment, [&](Vec3 w, double) {
      ASSERT_LE(luminance(light.radiance(w)), 4.0001f * light.pdf(w) * 4 * kPi * light.meanLuminance())
          << c.name;
    });
  }
}

// Bins of the world: equal steps of height and azimuth.
std::size_t binOf(Vec3 w, int rings, int sectors) {
  const double turn = std::atan2(w.y, w.x) / (2 * kPi);
  const int ring = std::clamp(static_cast<int>((w.z + 1) / 2 * rings), 0, rings - 1);
  const int sector = std::min(static_cast<int>((turn < 0 ? turn + 1 : turn) * sectors), sectors - 1);
  return static_cast<std::size_t>(ring * sectors + sector);
}

TEST(EnvironmentLight, SamplesFollowTheirPdf) {
  constexpr int kRings = 8, kSectors = 12, kSub = 24, kSamples = 40000;
  for (const Case& c : cases()) {
    const EnvironmentLight light(c.environment);
    test::Histogram seen(kRings * kSectors), expected(kRings * kSectors);
    for (std::uint64_t i = 0; i < kSamples; ++i)
      ++seen[binOf(light.sample(toUnit(hashKey(1, i)), toUnit(hashKey(2, i))).direction, kRings, kSectors)];
    for (int j = 0; j < kRings * kSub; ++j) {
      for (int i = 0; i < kSectors * kSub; ++i) {
        const double z = 2 * (j + 0.5) / (kRings * kSub) - 1, phi = 2 * kPi * (i + 0.5) / (kSectors * kSub);
        const Vec3 w =
            toFloat({std::sqrt(1 - z * z) * std::cos(phi), std::sqrt(1 - z * z) * std::sin(phi), z});
        expected[binOf(w, kRings, kSectors)] +=
            light.pdf(w) * 4 * kPi / (kRings * kSub * kSectors * kSub) * kSamples;
      }
    }
    EXPECT_LT(test::chiSquareScore(seen, expected), test::kScoreOf1In1000) << c.name;
  }
}

TEST(EnvironmentLight, SamplesCarryRadianceAndPdfOfTheirDirection) {
  for (const Case& c : cases()) {
    const EnvironmentLight light(c.environment);
    for (std::uint64_t i = 0; i < 200; ++i) {
      const EnvironmentSample s = light.sample(toUnit(hashKey(1, i)), toUnit(hashKey(2, i)));
      ASSERT_NEAR(length(s.direction), 1, 1e-6) << c.name;
      ASSERT_GT(s.pdf, 0) << c.name;
      ASSERT_EQ(s.pdf, light.pdf(s.direction)) << c.name;
      const Rgb radiance = light.radiance(s.direction);  // may be rounded otherwise
      ASSERT_FLOAT_EQ(s.radiance.x, radiance.x) << c.name;
      ASSERT_FLOAT_EQ(s.radiance.y, radiance.y) << c.name;
      ASSERT_FLOAT_EQ(s.radiance.z, radiance.z) << c.name;
    }
  }
}

// The mean of radiance / pdf is the light of the whole sphere.
TEST(EnvironmentLight, SamplesEstimateTheWhole) {
  constexpr int kSamples = 20000;
  for (const Case& c : cases()) {
    const EnvironmentLight light(c.environment);
    double whole = 0, sum = 0, squares = 0;
    forSphere(c.environment,
              [&](Vec3 w, double solid_angle) { whole += luminance(light.radiance(w)) * solid_angle; });
    for (std::uint64_t i = 0; i < kSamples; ++i) {
      const EnvironmentSample s = light.sample(toUnit(hashKey(1, i)), toUnit(hashKey(2, i)));
      const double x = luminance(s.radiance) / s.pdf;
      sum += x, squares += x * x;
    }
    const double mean = sum / kSamples,
                 error = std::sqrt(std::max(0.0, squares / kSamples - mean * mean) / kSamples);
    EXPECT_NEAR(mean, whole, 4 * error + 1e-3 * whole) << c.name;
    const double mean_luminance = whole / (4 * kPi);
    EXPECT_NEAR(light.meanLuminance(), mean_luminance,
                mean_luminance / std::pow(std::max(1, c.environment.picture.height), 2))
        << c.name;
  }
}

// Straight along -z is the seam of the picture; a quarter of its width further right is +x.
TEST(EnvironmentLight, ShowsPixelsWhereTheSceneSays) {
  const Environment e = noisy(4, 3);
  const EnvironmentLight light(e);
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 4; ++i) {
      const Rgb seen = light.radiance(directionOf((i + 0.5) / 4, (j + 0.5) / 3));
      EXPECT_NEAR(luminance(seen - e.picture.pixels[static_cast<std::size_t>(4 * j + i)]), 0, 1e-4f);
    }
  }
  const Environment ahead = picture(4, 1, {{1, 0, 0}, {2, 0, 0}, {4, 0, 0}, {8, 0, 0}});
  const EnvironmentLight horizon(ahead);
  EXPECT_NEAR(horizon.radiance({0, 0, -1}).x, (8 + 1) / 2.f, 1e-5f);
  EXPECT_NEAR(horizon.radiance({1, 0, 0}).x, (1 + 2) / 2.f, 1e-5f);
  EXPECT_NEAR(horizon.radiance({0, 0, 1}).x, (2 + 4) / 2.f, 1e-5f);
  EXPECT_NEAR(horizon.radiance({-1, 0, 0}).x, (4 + 8) / 2.f, 1e-5f);
}

TEST(EnvironmentLight, FollowsItsTransform) {
  const Environment plain = noisy(8, 5);
  const EnvironmentLight own(plain);
  for (const Affine& to_world : {kOblique, kMirrored}) {
    const Environment e = turned(plain, to_world);
    const EnvironmentLight light(e);
    forSphere(plain, [&](Vec3 w, double) {
      const Vec3 there = toFloat(mapVector(to_world, toDouble(w)));
      ASSERT_NEAR(luminance(light.radiance(there) - own.radiance(w)), 0, 1e-3f);
    });
  }
}

TEST(EnvironmentLight, PolesShowTheirRow) {
  const Environment e = picture(2, 2, {{1, 1, 1}, {3, 3, 3}, {5, 5, 5}, {7, 7, 7}});
  const EnvironmentLight light(e);
  const float up = light.radiance({0, 1, 0}).x, down = light.radiance({0, -1, 0}).x;
  EXPECT_TRUE(up >= 1 && up <= 3);
  EXPECT_TRUE(down >= 5 && down <= 7);
  for (const float y : {1.f, -1.f}) EXPECT_GT(light.pdf({0, y, 0}), 0);
  // A lamp of one pixel around the zenith of a large picture.
  std::vector<Rgb> pixels(512 * 256);
  pixels[0] = {1, 1, 1};
  const Environment sun = picture(512, 256, std::move(pixels));
  const EnvironmentLight zenith(sun);
  for (std::uint64_t i = 0; i < 100; ++i) {
    const EnvironmentSample s = zenith.sample(toUnit(hashKey(1, i)), toUnit(hashKey(2, i)));
    EXPECT_GT(s.radiance.x, 0);
    EXPECT_GT(s.pdf, 100);
  }
}

TEST(EnvironmentLight, OneColorIsUniform) {
  for (const Environment& e :
       {Environment{{2, 3, 4}, {}, {}}, Environment{{2, 3, 4}, {1, 1, {{1, 1, 1}}}, {}}}) {
    const EnvironmentLight light(e);
    EXPECT_FLOAT_EQ(light.meanLuminance(), luminance({2, 3, 4}));
    for (const float u : {0.f, 0.3f, kLargest}) {
      const EnvironmentSample s = light.sample(u, 0.7f);
      EXPECT_FLOAT_EQ(s.pdf, kUniform);
      EXPECT_NEAR(length(s.radiance - Rgb{2, 3, 4}), 0, 1e-5f);
      EXPECT_NEAR(s.direction.y, 1 - 2 * u, 1e-6f);
    }
  }
}

TEST(EnvironmentLight, BlackGivesNothing) {
  for (const Environment& e :
       {Environment{}, picture(3, 2, std::vector<Rgb>(6)), Environment{{}, {1, 1, {{1, 1, 1}}}, {}}}) {
    const EnvironmentLight light(e);
    const EnvironmentSample s = light.sample(0.5f, 0.5f);
    EXPECT_EQ(s.pdf, 0);
    EXPECT_EQ(s.radiance, Rgb{});
    EXPECT_EQ(light.pdf({0, 1, 0}), 0);
    EXPECT_EQ(light.radiance({0, 0, 1}), Rgb{});
  }
}

TEST(EnvironmentLight, TheEdgesOfTheUnitSquareAreFine) {
  for (const Case& c : cases()) {
    const EnvironmentLight light(c.environment);
    for (const float u1 : {0.f, kLargest}) {
      for (const float u2 : {0.f, kLargest}) {
        const EnvironmentSample s = light.sample(u1, u2);
        EXPECT_NEAR(length(s.direction), 1, 1e-6) << c.name;
        EXPECT_TRUE(s.pdf >= 0 && std::isfinite(s.pdf)) << c.name;
      }
    }
  }
}

}  // namespace
}  // namespace saccade
