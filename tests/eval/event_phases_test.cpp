#include "eval/metrics/event_phases.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace saccade::eval {
namespace {

// `count` events, each in a pixel of its own from `first` on; binOf(i) gives their phases.
template <class BinOf>
PhasedEvents eventsIn(int count, std::uint32_t first, BinOf binOf) {
  PhasedEvents events;
  for (int i = 0; i < count; ++i) events.push_back({first + static_cast<std::uint32_t>(i), binOf(i)});
  return events;
}
PhasedEvents even(int count, std::uint32_t first = 0) {
  return eventsIn(count, first, [](int i) { return i % kPhaseBins; });
}

TEST(PhasesOf, AreTenthsOfTheIntervalAroundAnEvent) {
  const FrameIntervals frames = {{10'000, 20'000}, {20'000, 60'000}};
  const Events events = {{9'000, 1, 2, 1},  {10'000, 1, 2, 1}, {19'000, 1, 2, 0}, {20'000, 1, 2, 1},
                         {23'000, 1, 2, 1}, {24'000, 3, 2, 1}, {59'000, 1, 2, 1}, {60'000, 1, 2, 1}};
  std::vector<int> bins;
  for (const PhasedEvent& e : phasesOf(events, frames)) bins.push_back(e.bin);
  EXPECT_EQ(bins, (std::vector<int>{0, 9, 0, 0, 1, 9}));
  const PhasedEvents phased = phasesOf(events, frames);
  EXPECT_EQ(phased[0].pixel, phased[1].pixel);
  EXPECT_NE(phased[3].pixel, phased[4].pixel);
  EXPECT_TRUE(phasesOf(events, {}).empty());
}

TEST(PhaseError, OfEqualStreamsIsZero) {
  EXPECT_EQ(phaseError(even(73), even(73)), 0);
}

TEST(PhaseError, OfNoEventIsUnknown) {
  EXPECT_TRUE(std::isnan(phaseError({}, even(10))));
  EXPECT_TRUE(std::isnan(phaseError(even(10), {})));
  EXPECT_TRUE(std::isnan(phaseError({}, {})));
}

// Nine tenths of the events lie in another bin. Only the even phases are random: V = 0.1 0.9 / n in each bin.
TEST(PhaseError, OfAllInOneTenth) {
  const int n = 1000;
  const PhasedEvents bunched = eventsIn(500, n, [](int) { return 3; });
  const double E = 10 * std::sqrt(2 * 0.09 / n / std::numbers::pi) / 2;
  EXPECT_NEAR(phaseError(bunched, even(n)), std::sqrt(0.81 - E * E), 1e-12);
  EXPECT_NEAR(phaseError(even(n), bunched), std::sqrt(0.81 - E * E), 1e-12);
}

// Disjoint bins, and nothing random about either.
TEST(PhaseError, IsOneAtMost) {
  const auto in = [](int bin) { return eventsIn(20, 0, [bin](int) { return bin; }); };
  EXPECT_DOUBLE_EQ(phaseError(in(0), in(9)), 1);
}

// Pixels that all have the same ten events, and half as many in the first tenth: 9.5 events in all.
TEST(PhaseError, OfFewerInTheFirstTenth) {
  PhasedEvents ref, x;
  for (std::uint32_t pixel = 0; pixel < 40'000; ++pixel) {
    for (int bin = 0; bin < kPhaseBins; ++bin) {
      ref.push_back({pixel, bin});
      if (bin > 0 || pixel % 2 == 0) x.push_back({pixel, bin});
    }
  }
  EXPECT_NEAR(phaseError(x, ref), 0.1 - 0.5 / 9.5, 1e-3);
}

// Of independent streams with equal distributions D^2 - E^2 is the variance of D, in the mean. For k bins it
// is about E^2 (pi / 2 - 1) / k.
TEST(PhaseError, OfChanceAloneIsLostInTheNoise) {
  constexpr int kCount = 400, kRounds = 2000;
  std::mt19937 random(7);
  std::uniform_int_distribution<int> bin(0, kPhaseBins - 1);
  const auto draw = [&](std::uint32_t first) {
    return eventsIn(kCount, first, [&](int) { return bin(random); });
  };
  double squares = 0;
  int negative = 0;
  for (int i = 0; i < kRounds; ++i) {
    const double error = phaseError(draw(0), draw(kCount));
    squares += error * std::abs(error) / kRounds;
    negative += error < 0;
  }
  const double E = 10 * std::sqrt(2 * 2 * 0.09 / kCount / std::numbers::pi) / 2;
  EXPECT_NEAR(squares / (E * E), (std::numbers::pi / 2 - 1) / kPhaseBins, 0.05);
  EXPECT_NEAR(negative, kRounds / 2, kRounds / 10);
}

}  // namespace
}  // namespace saccade::eval
