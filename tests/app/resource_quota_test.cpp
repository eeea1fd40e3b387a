#include "app/admission/resource_quota.h"

#include <gtest/gtest.h>

#include "app/admission/stream_cost.h"

namespace saccade {
namespace {

// The refusal that `action` throws; one without a code if it throws none.
template <class Action>
Refusal refusalOf(Action action) {
  try {
    action();
  } catch (const Refusal& refusal) {
    return refusal;
  }
  return {v1::CODE_OK, {}, "no refusal"};
}

class Quota : public testing::Test {
 protected:
  static Limits small() {
    Limits limits;
    limits[Limit::kStreams] = 3, limits[Limit::kClientStreams] = 2;
    limits[Limit::kSensors] = 10, limits[Limit::kClientSensors] = 10;
    limits[Limit::kPictures] = 4;
    return limits;
  }
  Refusal refusal(const std::string& client, const std::vector<Share>& shares) {
    return refusalOf([&] { quota_.take(client, shares); });
  }
  ResourceQuota quota_{small()};
};

TEST_F(Quota, AllClientsTogetherHaveOneLimit) {
  const auto a = quota_.take("a", {{Limit::kStreams, 2}}), b = quota_.take("b", {{Limit::kStreams, 1}});
  const Refusal refused = refusal("c", {{Limit::kStreams, 1, "scene"}});
  EXPECT_EQ(refused.code, v1::CODE_RESOURCE_EXHAUSTED);
  EXPECT_EQ(refused.limit, "streams");
  EXPECT_EQ(refused.field, "scene");
  EXPECT_STREQ(refused.what(), "limit streams: 1 more would exceed 3, 3 are taken");
  EXPECT_EQ(refused.retry_after_s, kRetrySeconds);
}

TEST_F(Quota, AClientHasALimitOfItsOwn) {
  const auto a = quota_.take("a", {{Limit::kStreams, 2}});
  const Refusal refused = refusal("a", {{Limit::kStreams, 1}});
  EXPECT_EQ(refused.limit, "client-streams");
  EXPECT_EQ(refused.retry_after_s, 0);  // the client must close one of its own
  EXPECT_EQ(refusal("b", {{Limit::kStreams, 1}}).code, v1::CODE_OK);
}

TEST_F(Quota, WithoutKeysTheLimitsOfOneClientBindNobody) {
  const auto first = quota_.take("", {{Limit::kStreams, 2}});
  EXPECT_EQ(refusal("", {{Limit::kStreams, 1}}).code, v1::CODE_OK);
  EXPECT_EQ(refusal("", {{Limit::kStreams, 2}}).limit, "streams");
}

TEST_F(Quota, MoreThanTheWholeLimitIsNotWorthTryingAgain) {
  EXPECT_EQ(refusal("", {{Limit::kStreams, 4}}).retry_after_s, 0);
}

TEST_F(Quota, TakesAllSharesOrNone) {
  EXPECT_EQ(refusal("a", {{Limit::kStreams, 2}, {Limit::kSensors, 11}}).limit, "client-sensors");
  EXPECT_EQ(refusal("a", {{Limit::kStreams, 2}, {Limit::kSensors, 10}}).code, v1::CODE_OK);
}

TEST_F(Quota, GivesBackWhenTheLastCopyGoes) {
  auto first = quota_.take("a", {{Limit::kStreams, 2}});
  auto copy = first;
  first.reset();
  EXPECT_EQ(refusal("a", {{Limit::kStreams, 1}}).limit, "client-streams");
  copy.reset();
  EXPECT_EQ(refusal("a", {{Limit::kStreams, 2}}).code, v1::CODE_OK);
}

TEST_F(Quota, ARateMayBeExceededOnceAndIsThenPaidOff) {
  quota_.use(Limit::kPictures, 4000);  // 1000 seconds at 4 MiB a second
  const Refusal refused = refusalOf([&] { quota_.use(Limit::kPictures, 0.1); });
  EXPECT_EQ(refused.limit, "pictures");
  EXPECT_STREQ(refused.what(), "limit pictures: more than 4 MiB a second are asked for");
  EXPECT_GT(refused.retry_after_s, 900);
  EXPECT_LE(refused.retry_after_s, 1000);
}

// As from clients that each ask for a little at one time.
TEST_F(Quota, ARateMayBeTakenAtOnceForASecond) {
  const auto began = std::chrono::steady_clock::now();
  int taken = 0;
  for (int i = 0; i < 1000; ++i)
    taken += refusalOf([&] { quota_.use(Limit::kPictures, 0.5); }).code == v1::CODE_OK;
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - began;
  EXPECT_GE(taken, 8);  // 4 MiB
  EXPECT_LE(taken, 9 + 8 * time.count());
}

TEST(Limits, AmountsAreWholeAboveOneAndHaveTheirUnit) {
  EXPECT_EQ(amountText(Limit::kMemory, 1.2), "2 MiB");
  EXPECT_EQ(amountText(Limit::kMemory, 0.25), "0.25 MiB");
  EXPECT_EQ(amountText(Limit::kStreams, 3), "3");
}

TEST(Limits, TheTableIsInTheOrderOfItsEnumeration) {
  for (std::size_t i = 0; i < kLimits; ++i) {
    EXPECT_EQ(kLimitTable[i].limit, static_cast<Limit>(i)) << kLimitTable[i].name;
    EXPECT_GE(kLimitTable[i].fallback, kLimitTable[i].min) << kLimitTable[i].name;
  }
}

TEST(Limits, ARefusalNamesTheFieldThatExceedsTheLimit) {
  Limits limits;
  limits[Limit::kFrameRate] = 100, limits[Limit::kPixelRays] = 40;
  v1::OpenStream request;
  request.mutable_timing()->set_frame_rate_hz(200);
  const Refusal rate = refusalOf([&] { checkAlone(request, limits); });
  EXPECT_EQ(rate.field, "timing.frame_rate_hz");
  EXPECT_STREQ(rate.what(), "limit frame-rate: 200 Hz exceed 100 Hz");
  request.mutable_timing()->set_frame_rate_hz(100);
  request.mutable_method()->set_spp(10);
  request.mutable_quality()->set_bounces(3);  // 10 (3 + 2) rays
  EXPECT_STREQ(refusalOf([&] { checkAlone(request, limits); }).what(), "limit pixel-rays: 50 exceed 40");
  request.mutable_method()->set_spp(8);
  EXPECT_EQ(refusalOf([&] { checkAlone(request, limits); }).code, v1::CODE_OK);
}

TEST(Limits, SensorsShareTheEventsOfAStream) {
  Limits limits;
  limits[Limit::kEvents] = 1000;
  ResolvedStream stream;
  for (int i = 0; i < 4; ++i) {
    stream.request.add_sensors();
    stream.sensors.emplace_back();
    stream.changes.emplace_back();
  }
  stream.request.mutable_timing()->set_frame_rate_hz(100);
  stream.request.mutable_sensors(1)->set_max_events_per_frame(100);
  boundEvents(stream, limits);
  EXPECT_EQ(stream.sensors[0].max_events_per_frame, 250u);
  EXPECT_EQ(stream.sensors[1].max_events_per_frame, 100u);
  stream.request.mutable_sensors(2)->set_max_events_per_frame(251);
  const Refusal refused = refusalOf([&] { boundEvents(stream, limits); });
  EXPECT_EQ(refused.limit, "events");
  EXPECT_EQ(refused.field, "sensors[2].max_events_per_frame");
}

TEST(Limits, TheNoiseOfAFrameFitsIntoItsEvents) {
  Limits limits;
  limits[Limit::kEvents] = 1000;
  ResolvedStream stream;
  stream.request.add_sensors();
  stream.sensors.emplace_back().noise.leak_hz = 5;
  stream.changes.emplace_back();
  stream.request.mutable_view()->set_width(100);
  stream.request.mutable_view()->set_height(100);
  stream.request.mutable_timing()->set_frame_rate_hz(50);
  boundEvents(stream, limits);
  stream.request.mutable_timing()->set_frame_rate_hz(49);
  const Refusal refused = refusalOf([&] { boundEvents(stream, limits); });
  EXPECT_EQ(refused.limit, "events");
  EXPECT_EQ(refused.field, "sensors[0].noise");
}

}  // namespace
}  // namespace saccade
