#include "render/lights/delta_lamps.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/lights/spot_weights.h"

namespace saccade {
namespace {

TEST(DeltaLamps, APointShinesByTheSquareOfItsDistance) {
  Scene s;
  s.point_lights = {{{0, 3, 4}, {10, 20, 30}}};
  const IncidentLight light = DeltaLamps(s, Lamps(s)).at(0, {});
  EXPECT_NEAR(light.direction.z, 0.8, 1e-6);
  EXPECT_NEAR(light.radiance.y, 20. / 25, 1e-6);
  EXPECT_NEAR(length(light.segment) * light.reach, 5, 1e-3);
}

TEST(DeltaLamps, ASunShinesAlikeEverywhere) {
  Scene s;
  s.point_lights = {{{0, 3, 4}, {1, 1, 1}}};
  s.directional_lights = {{{0, 0, -1}, {2, 2, 2}}};
  const DeltaLamps lamps(s, Lamps(s));
  ASSERT_EQ(lamps.size(), 2u);
  for (const Vec3 point : {Vec3{}, Vec3{5, -3, 100}}) {
    const IncidentLight light = lamps.at(1, point);
    EXPECT_EQ(light.direction, (Vec3{0, 0, 1}));
    EXPECT_EQ(light.radiance.x, 2);
    EXPECT_TRUE(std::isinf(light.reach));
  }
}

TEST(DeltaLamps, AreFewUpToSixteenAndGetRaysUpToALimit) {
  Scene s;
  const auto lamps = [&](std::size_t count) {
    s.point_lights.resize(count, {{}, {1, 1, 1}});
    return DeltaLamps(s, Lamps(s));
  };
  EXPECT_FALSE(lamps(0).getRays());
  EXPECT_TRUE(lamps(16).getRays() && lamps(16).areFew());
  EXPECT_TRUE(lamps(17).getRays() && !lamps(17).areFew());
  EXPECT_TRUE(lamps(256).getRays());
  EXPECT_FALSE(lamps(257).getRays());
}

// Within the beam of a spot, and in all directions of a point, the weight is the light. Beyond a cone, below
// the surface and in the lanes without a lamp it is 0.
TEST(SpotWeights, AreWhatASurfaceReflects) {
  Scene s;
  const Vec3 down{0, 0, -1};
  for (int i = 0; i < 9; ++i)
    s.point_lights.push_back({{static_cast<float>(i), 1, static_cast<float>(i) - 2}, {1, 2, 3}});
  s.spot_lights = {{{0.1f, 0, 4}, down, {5, 5, 5}, 0.3f, 0.4f}, {{3, 0, 2}, down, {5, 5, 5}, 0.3f, 0.4f}};
  const DeltaLamps lamps(s, Lamps(s));
  alignas(32) float weights[16];
  SpotWeights(Lamps(s).spots()).at({}, {0, 0, 0.5f}, weights);
  for (std::size_t i = 0; i < lamps.size(); ++i) {
    const IncidentLight light = lamps.at(i, {});
    const float reflected = 0.5f * luminance(light.radiance) * std::max(0.f, light.direction.z);
    EXPECT_NEAR(weights[i], reflected, 1e-5f * reflected) << i;
  }
  EXPECT_GT(weights[9], 0);
  EXPECT_EQ(weights[10], 0);
  for (std::size_t i = lamps.size(); i < 16; ++i) EXPECT_EQ(weights[i], 0);
}

}  // namespace
}  // namespace saccade
