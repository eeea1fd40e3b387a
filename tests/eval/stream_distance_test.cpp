#include "eval/metrics/stream_distance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "eval/metrics/nearest_event.h"
#include "eval/metrics/stream_summary.h"

namespace saccade::eval {
namespace {

constexpr std::int64_t kMs = 1'000'000;
constexpr int kSide = 64;

// `count` ON events of one pixel, 10 ms apart.
Events every10ms(int count, std::uint16_t x = 20, std::int64_t first_ns = 0) {
  Events events;
  for (int i = 0; i < count; ++i) events.push_back({first_ns + 10 * i * kMs, x, 30, 1});
  return events;
}

StreamDistance distanceOf(const Events& a, const Events& b) {
  StreamDistance distance(kSide, kSide);
  distance.add(a, b);
  return distance;
}

TEST(NearestEvent, IsThatOfASearchThroughAll) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(0, 10);
  const auto place = [&] {
    return EventPlace{uniform(random), uniform(random), uniform(random), float(random() % 2)};
  };
  std::vector<EventPlace> places(500);
  for (EventPlace& p : places) p = place();
  const NearestEvent tree(places);
  for (int i = 0; i < 500; ++i) {
    const EventPlace at = place();
    double nearest = std::numeric_limits<double>::infinity();
    for (const EventPlace& p : places) {
      double sum = 0;
      for (std::size_t k = 0; k < p.size(); ++k) sum += std::pow(double(p[k]) - double(at[k]), 2);
      nearest = std::min(nearest, std::sqrt(sum));
    }
    EXPECT_DOUBLE_EQ(tree.distance(at), nearest);
  }
}

TEST(StreamDistance, OfEqualStreamsIsZero) {
  const StreamDistance d = distanceOf(every10ms(9), every10ms(9));
  EXPECT_EQ(d.countError(), 0);
  EXPECT_EQ(d.chamfer(), 0);
  EXPECT_EQ(d.gaussian(), 0);
  EXPECT_EQ(d.chamferPx(), 0);
  EXPECT_EQ(d.alone(), 0u);
}

// Both ways each event is 2 ms or 3 px from its own. The scale of PECS hides it.
TEST(StreamDistance, OfAShiftedStreamIsTwiceTheShift) {
  EXPECT_NEAR(distanceOf(every10ms(9), every10ms(9, 20, 2 * kMs)).chamferPx(), 2 * 2, 1e-6);
  EXPECT_EQ(distanceOf(every10ms(9), every10ms(9, 20, 2 * kMs)).chamfer(), 0);
  EXPECT_NEAR(distanceOf(every10ms(9), every10ms(9, 23)).chamferPx(), 2 * 3, 1e-6);
  EXPECT_EQ(distanceOf(every10ms(9), every10ms(9, 23)).countError(), 2);
}

// Of 9 events the 4 odd ones are missing, each 10 ms from the nearest that is left.
TEST(StreamDistance, OfAThinnedStreamIsThatOfTheMissingEvents) {
  const Events all = every10ms(9);
  Events thin;
  for (std::size_t i = 0; i < all.size(); i += 2) thin.push_back(all[i]);
  const StreamDistance d = distanceOf(thin, all);
  EXPECT_NEAR(d.chamferPx(), 10 * 4 / 9.0, 1e-6);
  EXPECT_NEAR(d.chamfer(), 1000 / 8.0 * 4 / 9.0, 1e-3) << "80 ms are scaled to 1000";
  EXPECT_NEAR(d.gaussian(), 4 / 9.0, 1e-6);
  EXPECT_DOUBLE_EQ(d.countError(), 4 / 9.0);
  EXPECT_EQ(d.difference().at(20, 30), -4);
}

TEST(StreamDistance, CountsPolaritiesApart) {
  Events off = every10ms(9);
  for (Event& e : off) e.p = 0;
  const StreamDistance d = distanceOf(off, every10ms(9));
  EXPECT_EQ(d.countError(), 2);
  EXPECT_NEAR(d.chamferPx(), 2 * 100, 1e-6);
  EXPECT_EQ(d.balanceOfA().at(20, 30), -9);
  EXPECT_EQ(d.balanceOfB().at(20, 30), 9);
}

TEST(StreamDistance, CountsEventsWithoutAnyOfTheOther) {
  StreamDistance d(kSide, kSide);
  d.add({}, {});
  EXPECT_EQ(d.countError(), 0);
  d.add(every10ms(3), {});
  EXPECT_EQ(d.alone(), 3u);
  EXPECT_TRUE(std::isnan(d.chamfer()));
  EXPECT_EQ(d.countError(), std::numeric_limits<double>::infinity());
}

TEST(StreamSummary, CountsEventsThatShareTheirTime) {
  StreamSummary summary;
  EXPECT_TRUE(std::isnan(summary.onShare()));
  summary.add({{0, 1, 1, 1}, {kMs, 1, 1, 0}, {kMs, 2, 1, 1}});
  summary.add({{kMs, 3, 1, 1}, {2 * kMs, 1, 1, 0}});  // a time may go on in the next batch
  EXPECT_EQ(summary.events(), 5u);
  EXPECT_DOUBLE_EQ(summary.seconds(), 2e-3);
  EXPECT_DOUBLE_EQ(summary.rate(), 2500);
  EXPECT_DOUBLE_EQ(summary.onShare(), 3 / 5.0);
  EXPECT_DOUBLE_EQ(summary.sameTimeShare(), 3 / 5.0);
  EXPECT_EQ(summary.mostAtOneTime(), 3u);
  EXPECT_DOUBLE_EQ(summary.sameTimeByChance(), -std::expm1(-2500e-6));
}

// Of a Poisson process of rate r in ticks of dt, an event has a tick for itself with probability exp(-r dt).
TEST(StreamSummary, ByChanceIsThatOfAPoissonProcess) {
  std::mt19937 random(3);
  std::exponential_distribution<double> gap(1.0 / 2000);  // ns
  StreamSummary summary;
  double t = 0;
  for (int i = 0; i < 100'000; ++i) {
    t += gap(random);
    summary.add({{static_cast<std::int64_t>(t) / kTimeUnitNs * kTimeUnitNs, 0, 0, 1}});
  }
  EXPECT_NEAR(summary.sameTimeShare(), summary.sameTimeByChance(), 0.01);
}

}  // namespace
}  // namespace saccade::eval
