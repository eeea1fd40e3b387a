#include "render/lights/delta_lamps.h"

#include <gtest/gtest.h>

#include <cmath>

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

}  // namespace
}  // namespace saccade
