#include "eval/metrics/regions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "eval/planes.h"

namespace saccade::eval {
namespace {

using test::plane;

constexpr int kSize = 9, kMid = 4;

float cosDeg(float degrees) {
  return std::cos(degrees * std::numbers::pi_v<float> / 180);
}

void setNormal(GBuffer& g, int x, int y, float tilt_deg) {
  g.nx.at(x, y) = std::sqrt(1 - cosDeg(tilt_deg) * cosDeg(tilt_deg));
  g.ny.at(x, y) = 0;
  g.nz.at(x, y) = cosDeg(tilt_deg);
}

// A plane of depth 10 + slope x. In the previous frame it was `shift` pixels to the right.
GBuffer wall(float slope = 0, float shift = 0) {
  GBuffer g(kSize, kSize);
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      g.z.at(x, y) = g.z_in_prev.at(x, y) = 10 + slope * static_cast<float>(x);
      g.dz.at(x, y) = std::abs(slope);
      g.motion_x.at(x, y) = shift;
      setNormal(g, x, y, 0);
    }
  }
  return g;
}

int countOf(const RegionMap& regions, std::uint32_t which) {
  int count = 0;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) count += (regions.at(x, y) & which) != 0;
  }
  return count;
}

TEST(Regions, AStandingWallIsSmooth) {
  EXPECT_EQ(countOf(findRegions(wall(), wall()), region::kSmooth), kSize * kSize);
}

TEST(Regions, NothingBeforeAndNothingNowIsSmooth) {
  GBuffer nothing(kSize, kSize);
  nothing.z_in_prev.fill(kMissDepth);
  EXPECT_EQ(countOf(findRegions(nothing, nothing), region::kSmooth), kSize * kSize);
}

TEST(Regions, WhereAWallEndsItIsASilhouetteWhateverTheNormals) {
  GBuffer g = wall();
  g.z.at(kMid, kMid) = g.z_in_prev.at(kMid, kMid) = kMissDepth;
  EXPECT_EQ(countOf(findRegions(g, g), region::kCurved), 9);
}

// A moving camera sees a steep wall. The depth of a pixel changes by as much as the slope allows; the surface
// stays the same.
TEST(Regions, ASlopeExplainsADepthThatChanges) {
  GBuffer prev = wall(1), cur = wall(1, 2);
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) prev.z.at(x, y) -= 2;  // z_in_prev of a point stands two pixels further
  }
  const RegionMap regions = findRegions(cur, prev);
  EXPECT_EQ(countOf(regions, region::kChanged), 2 * kSize);  // the points that came in from outside
  EXPECT_EQ(regions.at(kSize - 1, 0), region::kChanged);
  EXPECT_EQ(regions.at(kSize - 3, 0), region::kSmooth);

  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) cur.dz.at(x, y) = 0;  // the same depths on a wall that faces the camera
  }
  EXPECT_EQ(countOf(findRegions(cur, prev), region::kChanged), kSize * kSize);
}

// In the previous frame one pixel has another depth, and everything moves by one pixel. That pixel showed
// another surface, which hid the point behind it.
TEST(Regions, AnOccluderThatLeavesChangesItsPixelAndUncoversAPoint) {
  GBuffer prev = wall(), cur = wall(0, 1);
  prev.z.at(kMid, kMid) = 5;
  const RegionMap regions = findRegions(cur, prev);
  EXPECT_EQ(regions.at(kMid, kMid), region::kChanged);      // saw the occluder
  EXPECT_EQ(regions.at(kMid - 1, kMid), region::kChanged);  // its point was behind the occluder
  EXPECT_EQ(regions.at(kMid - 2, kMid), region::kSmooth);
  EXPECT_EQ(regions.at(kMid + 1, kMid), region::kSmooth);
  EXPECT_EQ(countOf(regions, region::kChanged), 2 + kSize);  // and the column that came in
}

TEST(Regions, DepthsWithinTheToleranceAreOneSurface) {
  GBuffer prev = wall();
  prev.z.at(kMid, kMid) = 10 * (1 + 0.9f * kDepthTolerance);
  EXPECT_EQ(countOf(findRegions(wall(), prev), region::kChanged), 0);
  prev.z.at(kMid, kMid) = 10 * (1 + 1.1f * kDepthTolerance);
  EXPECT_EQ(countOf(findRegions(wall(), prev), region::kChanged), 1);
}

TEST(Regions, ANormalThatTurnedIsAnotherSurface) {
  GBuffer prev = wall();
  setNormal(prev, kMid, kMid, kSameNormalDeg - 1);
  EXPECT_EQ(countOf(findRegions(wall(), prev), region::kChanged), 0);
  setNormal(prev, kMid, kMid, kSameNormalDeg + 1);
  EXPECT_EQ(countOf(findRegions(wall(), prev), region::kChanged), 1);
}

TEST(Regions, APointBehindThePreviousCameraIsNew) {
  GBuffer cur = wall(0.1f);
  cur.motion_x.at(kMid, kMid) = cur.motion_y.at(kMid, kMid) = 1e6f;
  EXPECT_EQ(findRegions(cur, wall(0.1f)).at(kMid, kMid), region::kChanged);
}

TEST(Regions, ATiltedNormalCurvesItsNeighbourhood) {
  GBuffer g = wall();
  setNormal(g, kMid, kMid, 0.9f * kCurvedDeg);
  EXPECT_EQ(countOf(findRegions(g, g), region::kCurved), 0);
  setNormal(g, kMid, kMid, 1.1f * kCurvedDeg);
  const RegionMap regions = findRegions(g, g);
  EXPECT_EQ(countOf(regions, region::kCurved), 9);
  EXPECT_EQ(regions.at(kMid + 1, kMid + 1), region::kCurved);
}

TEST(Median, IsOverTheRegionsAskedFor) {
  RegionMap regions(6, 1);
  const std::uint32_t map[] = {region::kSmooth,  region::kSmooth,  region::kCurved,
                               region::kChanged, region::kChanged, region::kSmooth};
  std::copy(std::begin(map), std::end(map), regions.row(0));
  const ImageF sigma = plane({5, 1, 2, 100, NAN, 9});
  EXPECT_EQ(median(sigma, regions, region::kSmooth), 5);
  EXPECT_EQ(median(sigma, regions, region::kUnchanged), 3.5);
  EXPECT_TRUE(std::isnan(median(sigma, regions, region::kChanged)));
  EXPECT_TRUE(std::isnan(median(sigma, regions, 0)));
}

}  // namespace
}  // namespace saccade::eval
