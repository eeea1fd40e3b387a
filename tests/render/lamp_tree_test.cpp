// The choice among many lamps.
#include "render/lights/lamps.h"

#include <gtest/gtest.h>

#include "base/hash_rng.h"
#include "render/render_mean.h"
#include "render/test_scenes.h"

namespace saccade {
namespace {

// Numbers in [0, 1), in order.
struct Numbers {
  std::uint32_t state = 1;
  float next() { return toUnit(mix32(state++)); }
  Vec3 place() { return {2 * next() - 1, 2 * next() - 1, 2 * next() - 1}; }
  Vec3 direction() { return normalize(place()); }
};

// Quads, spheres and points here and there in a cube of side 2, of powers from 1 to 100.
Scene manyLamps(int each) {
  Scene s;
  s.materials = {test::grey(0.5f)};
  Numbers u;
  const auto light = [&] { return Rgb{1, 1, 1} * std::pow(10.f, 2 * u.next()); };
  for (int i = 0; i < each; ++i) {
    const Vec3 a = u.direction(), b = normalize(cross(a, u.direction()));
    s.meshes.push_back(test::quad(u.place(), a * 0.05f, b * 0.05f, 0, light() * 100.f));
    s.spheres.push_back({"", u.place(), 0.03f, 0, light() * 100.f, {}});
    s.point_lights.push_back({u.place(), light()});
  }
  return s;
}

// All lamps together have a probability of 1, but for the numbers that end where no lamp shines.
TEST(LampTree, ProbabilitiesAddUpToOne) {
  const Lamps lamps(manyLamps(40));
  Numbers u{7};
  for (int i = 0; i < 50; ++i) {
    const Receiver at{u.place() * 2.f, u.direction()};
    for (const LightSet set : {LightSet::kAll, LightSet::kWithExtent}) {
      double sum = 0;
      for (std::uint32_t leaf = 0; leaf < lamps.tree(set).count(); ++leaf)
        sum += lamps.probability(set, leaf, at);
      int none = 0;
      for (int k = 0; k < 1000; ++k) none += lamps.choose(set, at, static_cast<float>(k) / 1000).pdf <= 0;
      if (none == 0)
        EXPECT_NEAR(sum, 1, 2e-3);
      else
        EXPECT_NEAR(sum, 1 - none / 1000., 0.06);
    }
  }
}

// Many numbers choose each lamp as often as its probability says, and it tells the same one.
TEST(LampTree, ChoosesByTheProbabilities) {
  const Lamps lamps(manyLamps(10));
  const Receiver at{{0.2f, -0.1f, 0.3f}, {0, 0, 1}};
  constexpr int kNumbers = 100000;
  std::vector<double> share(lamps.count());
  for (int i = 0; i < kNumbers; ++i) {
    const ChosenLamp chosen =
        lamps.choose(LightSet::kAll, at, (static_cast<float>(i) + 0.5f) / static_cast<float>(kNumbers));
    share[chosen.number] += 1. / kNumbers;
    const std::uint32_t leaf = chosen.number < 20 ? chosen.number / 2 : chosen.number - 10;
    const double area = chosen.number < lamps.areaLamps().size()
                            ? lamps.areaLamps()[chosen.number].area() * (chosen.number < 20 ? 2 : 1)
                            : 1;
    ASSERT_NEAR(chosen.pdf * area, lamps.probability(LightSet::kAll, leaf, at),
                1e-5 + 1e-4 * chosen.pdf * area);
  }
  for (std::uint32_t leaf = 0; leaf < 30; ++leaf) {
    const double p = lamps.probability(LightSet::kAll, leaf, at);
    const double found = leaf < 10 ? share[2 * leaf] + share[2 * leaf + 1] : share[leaf + 10];
    EXPECT_NEAR(found, p, 1e-4 + 4 * std::sqrt(p / kNumbers)) << leaf;
  }
}

// Where a lamp can give light, it is chosen now and then: near, far, and at a grazing angle.
TEST(LampTree, NeverLeavesOutALampThatShines) {
  const Scene scene = manyLamps(20);
  const Lamps lamps(scene);
  Numbers u{3};
  for (int i = 0; i < 20000; ++i) {
    const Receiver at{u.place(), u.direction()};
    const auto number = static_cast<std::uint32_t>(u.next() * static_cast<float>(lamps.count()));
    const IncidentLight light = lamps.sample({number, 1}, at.point, u.next(), u.next());
    if (!(light.pdf > 0) || dot(light.direction, at.normal) <= 1e-3f) continue;
    const std::uint32_t leaf = number < 40 ? number / 2 : number - 20;
    EXPECT_GT(lamps.probability(LightSet::kAll, leaf, at), 0);
  }
}

// The frames of a moving camera see points that are less than a pixel apart: equal numbers choose equal
// lamps. A hall of side 8 has a thousand lamps at its ceiling, and a pixel of it is 12 mm wide.
TEST(LampTree, IsContinuousInThePoint) {
  Scene hall;
  hall.materials = {test::grey(0.5f)};
  for (int i = 0; i < 1000; ++i) {
    const Vec3 corner{0.25f * static_cast<float>(i % 32), 3, 0.25f * static_cast<float>(i / 32)};
    hall.meshes.push_back(test::quad(corner, {0.1f, 0, 0}, {0, 0, 0.1f}, 0, {1, 1, 1}));
  }
  const Lamps lamps(hall);
  Numbers u{5};
  constexpr int kPoints = 20000;
  int same = 0;
  for (int i = 0; i < kPoints; ++i) {
    const Receiver at{{8 * u.next(), 2 * u.next(), 8 * u.next()}, {0, 1, 0}};
    const Receiver moved{at.point + u.direction() * 0.004f, at.normal};
    const float number = u.next();
    same +=
        lamps.choose(LightSet::kAll, at, number).number == lamps.choose(LightSet::kAll, moved, number).number;
  }
  EXPECT_GE(same, 0.99 * kPoints);
}

// The two triangles of a quad are one lamp, which needs no tree.
TEST(LampTree, IsThereForSeveralLampsAlone) {
  Scene s;
  s.materials = {test::grey(0.5f)};
  s.meshes = {test::quad({}, {1, 0, 0}, {0, 1, 0}, 0, {1, 1, 1})};
  EXPECT_FALSE(Lamps(s).hasTree(LightSet::kAll));
  s.point_lights = {{{}, {1, 1, 1}}};
  EXPECT_TRUE(Lamps(s).hasTree(LightSet::kAll));
  EXPECT_FALSE(Lamps(s).hasTree(LightSet::kWithExtent));
}

}  // namespace
}  // namespace saccade
