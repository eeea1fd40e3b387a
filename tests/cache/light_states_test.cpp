#include "cache/grid/light_states.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace saccade
