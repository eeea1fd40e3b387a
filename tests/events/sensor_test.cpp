#include "events/sensor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <tuple>

#include "base/counting_new.h"
#include "events/log_response.h"

namespace saccade {
namespace {

constexpr int kWidth = 37, kHeight = 11;

// Fills interval `frame` (1, 2, ...), 2 ms long, with random changes of about `size`; a quarter stands still.
void fillRandom(IntensityChange& change, FrameIndex frame, float size) {
  std::mt19937 random(static_cast<unsigned>(frame));
  std::uniform_real_distribution<float> uniform(-size, size);
  change.frame = frame;
  change.t0 = frameTime(frame - 1, 500);
  change.t1 = frameTime(frame, 500);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      change.I_prev.at(x, y) = 1;
      change.dI.at(x, y) = random() % 4 ? uniform(random) : 0;
    }
  }
}

class SensorOfModel : public testing::TestWithParam<std::string> {
 protected:
  SensorConfig config() const { return {.model = GetParam(), .seed = 1}; }

  Events eventsOf(const SensorConfig& config, int frames = 10) const {
    Sensor sensor(config, kWidth, kHeight);
    IntensityChange change(kWidth, kHeight);
    SensorOutput out;
    Events all;
    for (int i = 1; i <= frames; ++i) {
      fillRandom(change, i, 0.6f);
      sensor.generate(change, out);
      all.insert(all.end(), out.events.begin(), out.events.end());
    }
    return all;
  }
};

TEST_P(SensorOfModel, EventsAreInOrderAndInsideTheInterval) {
  Sensor sensor(config(), kWidth, kHeight);
  IntensityChange change(kWidth, kHeight);
  SensorOutput out;
  for (int i = 1; i <= 10; ++i) {
    fillRandom(change, i, 0.9f);
    sensor.generate(change, out);
    ASSERT_FALSE(out.events.empty());
    const auto key = [](const Event& e) { return std::tuple(e.t_ns, e.y, e.x, e.p); };
    for (std::size_t k = 0; k < out.events.size(); ++k) {
      const Event& e = out.events[k];
      EXPECT_GE(e.t_ns, change.t0.count());
      EXPECT_LT(e.t_ns, change.t1.count());
      EXPECT_TRUE(e.x < kWidth && e.y < kHeight);
      if (k > 0) {
        EXPECT_LE(key(out.events[k - 1]), key(e));
      }
    }
  }
}

TEST_P(SensorOfModel, EqualSeedsGiveEqualEventsAndOthersOthers) {
  SensorConfig other = config();
  other.seed = 2;
  EXPECT_EQ(eventsOf(config()), eventsOf(config()));
  EXPECT_NE(eventsOf(config()), eventsOf(other));
}

TEST_P(SensorOfModel, AStandingSceneGivesNoEvents) {
  Sensor sensor(config(), kWidth, kHeight);
  IntensityChange change(kWidth, kHeight);
  SensorOutput out;
  for (int i = 1; i <= 5; ++i) {
    fillRandom(change, i, 0);
    sensor.generate(change, out);
    EXPECT_TRUE(out.events.empty());
    EXPECT_EQ(out.suppressed, 0u);
  }
}

TEST_P(SensorOfModel, DegenerateInputGivesBoundedEvents) {
  Sensor sensor(config(), kWidth, kHeight);
  IntensityChange change(kWidth, kHeight);
  fillRandom(change, 1, 0);
  const float values[] = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                          3e38f, -3e38f};
  for (int x = 0; x < kWidth; ++x) change.dI.at(x, 0) = values[x % 4];
  SensorOutput out;
  sensor.generate(change, out);
  for (const Event& e : out.events) EXPECT_GE(e.x % 4, 2) << "NaN and Inf give no event";
  EXPECT_EQ(out.events.size(), 32u * (kWidth / 4) * 2);
}

// The bound changes no event that it lets pass, and the pixels behave as if all had been sent.
TEST_P(SensorOfModel, BeyondItsBoundAFrameWithholdsTheLastPixels) {
  SensorConfig bounded = config();
  bounded.max_events_per_frame = 100;
  Sensor sensor(bounded, kWidth, kHeight), free(config(), kWidth, kHeight);
  IntensityChange change(kWidth, kHeight);
  SensorOutput out, all;
  for (int i = 1; i <= 10; ++i) {
    fillRandom(change, i, i % 2 ? 0.9f : 0.2f);
    sensor.generate(change, out);
    free.generate(change, all);
    EXPECT_EQ(out.events.size() + out.suppressed, all.events.size() + all.suppressed);
    const auto inOrder = [](const Event& a, const Event& b) {
      return std::tie(a.y, a.x) < std::tie(b.y, b.x);
    };
    for (Events* events : {&out.events, &all.events}) std::ranges::stable_sort(*events, inOrder);
    all.events.resize(std::min<std::size_t>(100, all.events.size()));
    EXPECT_EQ(out.events, all.events);
  }
}

// A cut makes many at once, and then none.
TEST_P(SensorOfModel, GivesBackTheMemoryOfManyEvents) {
  constexpr int kSide = 256;
  SensorConfig low = config();
  low.threshold = low.threshold_off = 0.01;
  low.max_events_per_frame = 500'000;
  Sensor sensor(low, kSide, kSide);
  IntensityChange change(kSide, kSide);
  change.I_prev.fill(1);
  SensorOutput out;
  std::size_t largest = 0;
  for (int i = 1; i <= 4; ++i) {
    change.frame = i, change.t0 = frameTime(i - 1, 500), change.t1 = frameTime(i, 500);
    change.dI.fill(i == 1 ? 1.f : 0.f);
    sensor.generate(change, out);
    largest = std::max(largest, out.events.capacity());
  }
  EXPECT_LE(largest, 1'000'000u);
  EXPECT_LT(out.events.capacity(), 1u << 16);
}

TEST_P(SensorOfModel, NothingAllocatesAfterTwoFrames) {
  for (const ReconstructionInfo& reconstruction : reconstructionTable()) {
    SensorConfig with_refractory = config();
    with_refractory.reconstruction = reconstruction.name;
    with_refractory.refractory = TimeNs(100'000);
    Sensor sensor(with_refractory, kWidth, kHeight);
    IntensityChange change(kWidth, kHeight);
    change.I_now.fill(1);
    change.var_dI.fill(0.01f);
    change.var_I_prev.fill(0.1f);
    SensorOutput out;
    for (int i = 1; i <= 10; ++i) {
      // The busiest frames come first: storage grows to the largest frame met.
      fillRandom(change, i, i <= 2 ? 0.99f : 0.5f);
      const int before = test::allocations();
      sensor.generate(change, out);
      if (i > 2) {
        EXPECT_EQ(test::allocations() - before, 0) << reconstruction.name << ", frame " << i;
      }
    }
  }
}

TEST_P(SensorOfModel, DirectGivesTheModelTheResponseItself) {
  SensorConfig direct = config();
  direct.reconstruction = "direct";
  Sensor sensor(direct, kWidth, kHeight);
  const auto model = findEventModel(GetParam())->make(config(), kWidth, kHeight);
  IntensityChange change(kWidth, kHeight);
  ImageF dL(kWidth, kHeight);
  SensorOutput out;
  for (int i = 1; i <= 10; ++i) {
    fillRandom(change, i, 0.6f);
    sensor.generate(change, out);
    Events events;
    logResponse(change, static_cast<float>(config().bias), dL);
    model->generate(dL, {change.t0, change.t1, change.frame}, events);
    TimeOrder().sort(events, {change.t0, change.t1, change.frame});
    EXPECT_EQ(out.events, events) << "frame " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Models, SensorOfModel, testing::Values("accumulating", "probabilistic"),
                         [](const auto& info) { return info.param; });

TEST(SensorConfig, FaultsNameTheFieldAndWhatIsValid) {
  EXPECT_FALSE(findFault({}));
  const auto fieldOf = [](const SensorConfig& config) {
    const auto fault = findFault(config);
    return fault ? fault->field : "none";
  };
  EXPECT_EQ(fieldOf({.threshold = 0}), "threshold");
  EXPECT_EQ(fieldOf({.threshold = std::nan("")}), "threshold");
  EXPECT_EQ(fieldOf({.threshold_off = -1}), "threshold_off");
  EXPECT_EQ(fieldOf({.bias = 0}), "bias");
  EXPECT_EQ(fieldOf({.refractory = TimeNs(-1)}), "refractory_s");
  EXPECT_EQ(fieldOf({.max_events_per_pixel_frame = 0}), "max_events_per_pixel_frame");
  EXPECT_EQ(fieldOf({.max_events_per_frame = 0}), "max_events_per_frame");
  EXPECT_EQ(fieldOf({.reconstruction_cutoff_hz = 0}), "cutoff_hz");
  EXPECT_EQ(findFault({.reconstruction = "poisson"})->message,
            "no reconstruction 'poisson'; there are: direct, complementary, kalman");
  EXPECT_EQ(fieldOf({.reconstruction = ""}), "reconstruction");
  EXPECT_EQ(findFault({.model = "best"})->message,
            "no event model 'best'; there are: accumulating, probabilistic, stochastic");
}

}  // namespace
}  // namespace saccade
