// Rays between two moments of a pixel.
#include "render/tiles/known_rays.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace saccade {
namespace {

constexpr float kPixel = 0.02f;

RayFacet facetAt(float px, double degrees = 0) {
  const double angle = degrees * std::numbers::pi / 180;
  return {{px * kPixel, 0, 0},
          {static_cast<float>(std::sin(angle)), 0, static_cast<float>(std::cos(angle))},
          kPixel};
}
constexpr RayBits kLit[]{{1, 0}};

// Whether rays from `at` are known from a facet before and one after.
bool tells(const RayFacet& before, const RayFacet& at, const RayFacet& after) {
  KnownRays known;
  const auto a = known.add(before, kLit), b = known.add(after, kLit);
  return known.between(a, b, at)[0].lit == 1;
}

TEST(KnownRays, ARayThatEndsAlikeBeforeAndAfterIsKnown) {
  KnownRays known;
  const RayBits before[]{{0b0011, 0b0100}, {0b1111, 0}}, after[]{{0b0101, 0b1010}, {0, 0b1111}};
  const auto a = known.add(facetAt(0), before), b = known.add(facetAt(0.1f), after);
  const KnownRays::Bits bits = known.between(a, b, facetAt(0.05f));
  EXPECT_EQ(bits[0].lit, 0b0001u);
  EXPECT_EQ(bits[0].dark, 0u);
  EXPECT_EQ(bits[1].lit | bits[1].dark, 0u);
  EXPECT_EQ(known.between(b, b, facetAt(0.1f))[1].dark, 0b1111u);
}

TEST(KnownRays, NothingIsKnownFromOneSide) {
  KnownRays known;
  const auto a = known.add(facetAt(0), kLit);
  EXPECT_EQ(known.between(a, a, facetAt(0))[0].lit, 1u);
  EXPECT_EQ(known.between(a, KnownRays::kNone, facetAt(0))[0].lit, 0u);
  EXPECT_EQ(known.between(KnownRays::kNone, a, facetAt(0))[0].lit, 0u);
}

TEST(KnownRays, OnlyNearFacetsThatHardlyTurnTell) {
  EXPECT_TRUE(tells(facetAt(-0.125f), facetAt(0), facetAt(0.125f)));
  EXPECT_FALSE(tells(facetAt(-0.125f), facetAt(0), facetAt(0.3f)));
  EXPECT_FALSE(tells(facetAt(-0.3f), facetAt(0), facetAt(0.125f)));
  EXPECT_TRUE(tells(facetAt(-0.125f, 7), facetAt(0), facetAt(0.125f, 7)));
  EXPECT_FALSE(tells(facetAt(-0.125f, 9), facetAt(0), facetAt(0.125f)));
  EXPECT_FALSE(tells(facetAt(-0.125f), facetAt(0), facetAt(0.125f, 9)));
}

}  // namespace
}  // namespace saccade
