#include "cache/grid/light_states.h"

#include <gtest/gtest.h>

#include "base/tile_pool.h"

namespace saccade {
namespace {

constexpr std::size_t kMemory = 1 << 20;

TEST(LightStates, ALampThatComesBackFindsItsLight) {
  LightStates states({}, kMemory);
  states.enter(5, 0);
  const LightState* const first = &states.current();
  EXPECT_TRUE(states.isNew());
  EXPECT_FALSE(states.changed());
  states.enter(6, 1);
  EXPECT_NE(&states.current(), first);
  EXPECT_EQ(&states.previous(), first);
  EXPECT_TRUE(states.isNew());
  EXPECT_TRUE(states.changed());
  states.enter(5, 2);
  EXPECT_EQ(&states.current(), first);
  EXPECT_FALSE(states.isNew());
  states.enter(5, 3);
  EXPECT_FALSE(states.changed());
}

TEST(LightStates, TheLeastRecentlyUsedIsForgotten) {
  LightStates states({}, kMemory);
  for (std::uint32_t t = 0; t < 8; ++t) states.enter(t, t);
  states.enter(0, 8);
  EXPECT_FALSE(states.isNew());
  states.enter(100, 9);  // takes the place of 1
  EXPECT_TRUE(states.isNew());
  states.enter(2, 10);
  EXPECT_FALSE(states.isNew());
  states.enter(1, 11);
  EXPECT_TRUE(states.isNew());
}

// Changes take as much memory as the grids: their vertices are half as many then.
TEST(LightStates, ChangesAreCounted) {
  const auto verticesKept = [](bool changes) {
    LightStates states({}, std::size_t{1} << 23);
    states.enter(1, 0);
    if (changes) states.keepChanges();
    TilePool pool(1);
    SurfaceGrid& grid = states.current().grid;
    for (int t = 0; t < 40; ++t) {
      SurfaceSamples on(64, 64, 1);
      for (std::size_t i = 0; i < on.indexOf(0, 64); ++i) {
        on[i] = {.share = 1, .kind = SurfaceKind::kDiffuse, .paths = 1};
        const Vec3 at{float(i % 64 + 64 * t), float(i / 64), 0};
        on.place(i) = {at * 0.01f, {0, 0, 1}, 0.01f, 0};
      }
      Placement at, before;
      grid.place(on, nullptr, pool, before, at);
    }
    return grid.vertices();
  };
  EXPECT_LT(verticesKept(true), verticesKept(false));
}

}  // namespace
}  // namespace saccade
