// Which PACED streams a server takes: those whose pace its threads suffice for.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <future>
#include <set>

#include "app/admission/limits.h"
#include "app/feeds/pace.h"
#include "mock/test_server.h"
#include "saccade/wire/ranges.h"

namespace saccade {
namespace {

Config withAdmission() {
  Config config = testConfig();
  config.limits[Limit::kCpu] = 85;
  return config;
}

v1::OpenStream pacedRequest(double frame_rate_hz, double speed) {
  v1::OpenStream request = tinyRequest();
  request.mutable_timing()->set_clock(v1::CLOCK_PACED);
  request.mutable_timing()->set_frame_rate_hz(frame_rate_hz);
  request.mutable_timing()->set_speed(speed);
  request.mutable_timing()->set_duration_s(5 / frame_rate_hz);
  return request;
}

// The number after `word`.
double numberAfter(const std::string& text, const std::string& word) {
  const auto at = text.find(word);
  return at == std::string::npos ? 0 : std::atof(text.c_str() + at + word.size());
}

// 4 ms at 500 frames a second are 2 threads; of 4, at 75 %, 3 are to be had.
TEST(Pace, AStreamFitsBesideTheOthersOrNot) {
  Limits limits;
  limits[Limit::kCpu] = 75;
  v1::Timing timing;
  timing.set_frame_rate_hz(500);
  timing.set_speed(1);
  EXPECT_NO_THROW(checkPace(timing, {0.003, 0.001}, {0.99, {}, 0}, {4, 1, 4}, limits));
  for (const auto& [taken, retry_s] : {std::pair(1.01, kRetrySeconds), {9.0, kRetrySeconds}}) {
    try {
      checkPace(timing, {0.003, 0.001}, {taken, {}, 0}, {4, 1, 4}, limits);
      FAIL() << taken;
    } catch (const LimitReached& reached) {
      EXPECT_EQ(reached.limit, "cpu");
      EXPECT_EQ(reached.retry_after_s, retry_s);
    }
  }
  timing.set_speed(2);
  try {
    checkPace(timing, {0.003, 0.001}, {}, {4, 1, 4}, limits);
    FAIL();
  } catch (const LimitReached& reached) {
    EXPECT_EQ(reached.retry_after_s, 0);  // not even on an idle server
    EXPECT_EQ(numberAfter(reached.what(), "a frame takes "), 4);
    EXPECT_EQ(numberAfter(reached.what(), "rate of "), 370);  // 375, rounded down
    EXPECT_EQ(numberAfter(reached.what(), "speed of "), 1.5);
  }
}

std::string refusalOf(double frame_rate_hz, const CpuCost& frame, const PaceLoad& taken, CpuSupply supply) {
  Limits limits;
  limits[Limit::kCpu] = 80;
  v1::Timing timing;
  timing.set_frame_rate_hz(frame_rate_hz);
  timing.set_speed(1);
  try {
    checkPace(timing, frame, taken, supply, limits);
    return {};
  } catch (const LimitReached& reached) {
    return reached.what();
  }
}

// However many threads there are, a frame comes after the one before it.
TEST(Pace, AFrameAndItsSensorsFitIntoItsPeriod) {
  const CpuSupply many{64, 1, 64};
  const CpuCost frame{0.02, 0.004, 0.003, 0.004};  // 3 ms by all threads together, then 4 ms of one sensor
  EXPECT_EQ(refusalOf(100, frame, {}, many), "");
  EXPECT_EQ(numberAfter(refusalOf(120, frame, {}, many), "rate of "), 110);  // 114, rounded down
  EXPECT_NE(refusalOf(100, frame, {}, {64, 0.8, 64}), "");                   // as fast as it is let
  // Another viewer of a feed of 2 ms whose viewers take as long as 6 ms by all threads together.
  const CpuCost viewer{0, 0.0002, 0, 0.0002};
  const PaceLoad taken{20, {2, 38.2, 0.2, 0.02}, 0};
  EXPECT_EQ(refusalOf(100, viewer, taken, many), "");
  EXPECT_NE(refusalOf(100, viewer, {20, {2, 38.4, 0.2, 0.02}, 0}, many), "");
  EXPECT_NE(refusalOf(100, viewer, {20, {2, 38.2, 0.25, 0.02}, 0}, many), "");
  EXPECT_EQ(refusalOf(100, viewer, {20, {}, 0}, many), "");  // that they are others' does not matter
}

TEST(Pace, NoneIsTakenWhileOneLags) {
  const CpuCost frame{0.001, 0.001, 0.001, 0.001};
  EXPECT_EQ(refusalOf(10, frame, {0, {}, 0.9}, {4, 1, 4}), "");
  EXPECT_NE(refusalOf(10, frame, {0, {}, 1.1}, {4, 1, 4}).find("behind its clock"), std::string::npos);
}

// Its feed is slow in any case.
TEST(Pace, AStreamJoinsALaggingFeedAndWhileOtherProgramsRun) {
  const CpuCost viewer{0, 0.001, 0, 0.001};
  EXPECT_EQ(refusalOf(100, viewer, {2, {}, 1.1}, {0.1, 0.1, 4}), "");
  EXPECT_NE(refusalOf(100, viewer, {3.2, {}, 0}, {4, 1, 4}), "");  // of 3.2 that it may take
}

// Everything fits into a share of a million percent.
TEST(Pace, AStreamThatLagsSaysSoAndKeepsOthersOut) {
  Config config = testConfig();
  config.limits[Limit::kCpu] = 1e9;
  TestServer server(config);
  v1::OpenStream request = pacedRequest(1e5, 1);
  request.mutable_timing()->set_duration_s(0);
  request.set_delivery(v1::DELIVERY_LIVE);
  const auto stream = server.client().open(request);
  MockSubscriber subscriber = server.dataSubscriber();
  subscriber.attach(stream);
  subscriber.giveCredit(1 << 30);
  std::uint64_t lag_ms = 0;
  while (lag_ms == 0) lag_ms = subscriber.receive().value().header.lag_ms();
  EXPECT_GT(lag_ms, 1000u);
  const v1::Status status = server.client().tryOpen(pacedRequest(10, 1));
  EXPECT_EQ(status.limit(), "cpu") << status.message();
  EXPECT_GT(status.retry_after_s(), 0);
  server.client().close(stream);
  const auto deadline = ChangeNotifier::Clock::now() + kPatience;
  auto code = v1::CODE_UNSPECIFIED;
  while (code != v1::CODE_OK && ChangeNotifier::Clock::now() < deadline)
    code = server.client().tryOpen(pacedRequest(10, 1)).code();
  EXPECT_EQ(code, v1::CODE_OK);
}

TEST(Pace, TheServerMeasuresAndSaysWhatFits) {
  TestServer server(withAdmission());
  const v1::Status status = server.client().tryOpen(pacedRequest(1e5, 1));
  EXPECT_EQ(status.code(), v1::CODE_RESOURCE_EXHAUSTED);
  EXPECT_EQ(status.limit(), "cpu");
  EXPECT_EQ(status.field(), "timing");
  EXPECT_EQ(status.retry_after_s(), 0);
  const double fits_hz = numberAfter(status.message(), "rate of ");
  const double fits_speed = numberAfter(status.message(), "speed of ");
  ASSERT_GT(fits_hz, 0) << status.message();
  EXPECT_EQ(server.client().tryOpen(pacedRequest(fits_hz / 8, 1)).code(), v1::CODE_OK);
  EXPECT_EQ(server.client().tryOpen(pacedRequest(1e3, 100 * fits_speed / 8)).code(), v1::CODE_OK);
}

// Its feed is rendered in any case, but not for as many sensors as one likes. Here one sensor takes a
// twentieth of the time of its feed (with ThreadSanitizer: half of it), give or take a busy machine.
TEST(Pace, AStreamThatJoinsAFeedCostsItsSensorsOnly) {
  TestServer server(withAdmission());
  const auto request = [](double frame_rate_hz, int sensors) {
    v1::OpenStream live = pacedRequest(frame_rate_hz, 1);
    live.set_delivery(v1::DELIVERY_LIVE);
    live.mutable_method()->set_name("pt");
    live.mutable_quality()->set_bounces(0);
    while (live.sensors_size() < sensors) *live.add_sensors() = live.sensors(0);
    return live;
  };
  const double fits_hz = numberAfter(server.client().tryOpen(request(1e5, 1)).message(), "rate of ");
  ASSERT_GT(fits_hz, 0);
  const double rate_hz = fits_hz / 8;
  for (int i = 0; i < 4; ++i) {
    const v1::Status status = server.client().tryOpen(request(rate_hz, 1));
    ASSERT_EQ(status.code(), v1::CODE_OK) << status.message();
  }
  v1::Status status;
  for (int i = 0; i < 7 && status.limit().empty(); ++i)  // no more sensors are allowed one client
    status = server.client().tryOpen(request(rate_hz, 64));
  EXPECT_EQ(status.limit(), "cpu") << status.message();
  EXPECT_GT(numberAfter(status.message(), "in each frame its sensors take "), 0) << status.message();
  EXPECT_EQ(numberAfter(status.message(), "rate of "), 0) << status.message();  // it would be another feed
}

// The speed that fits is the request's, halved as often as needed, and named by the reply.
TEST(Pace, ASpeedThatFitsIsTakenWhereTheRequestAllowsIt) {
  TestServer server(withAdmission());
  v1::OpenStream request = pacedRequest(1e3, 1);
  const double fits = numberAfter(server.client().tryOpen(pacedRequest(1e3, 1000)).message(), "speed of ");
  ASSERT_GT(fits, 0);
  request.mutable_timing()->set_speed(16 * fits);
  request.mutable_timing()->set_min_speed(std::max(fits / 64, ranges::kSpeed.min));
  const v1::Timing taken = server.client().open(request).resolved().timing();
  EXPECT_LE(taken.speed(), 2 * fits);  // a busy machine leaves less
  EXPECT_EQ(std::exp2(std::round(std::log2(16 * fits / taken.speed()))), 16 * fits / taken.speed());
  EXPECT_EQ(taken.min_speed(), 0);
  request.mutable_timing()->set_min_speed(17 * fits);
  EXPECT_EQ(server.client().tryOpen(request).field(), "timing.min_speed");
}

// A class opens one link. Each page had a feed of its own, measured beside the others, and was refused for
// it.
TEST(Pace, EqualStreamsThatAreOpenedTogetherShareOneFeed) {
  constexpr int kPages = 8;
  TestServer server(withAdmission());
  v1::OpenStream request = pacedRequest(1e3, 100);
  request.mutable_timing()->set_min_speed(1e-3);
  request.mutable_timing()->set_duration_s(0);
  request.set_delivery(v1::DELIVERY_LIVE);
  std::vector<std::future<double>> pages;
  for (int i = 0; i < kPages; ++i) {
    pages.push_back(std::async(std::launch::async, [&] {
      MockClient client(server.app().controlEndpoint());
      return client.open(request).resolved().timing().speed();
    }));
  }
  std::set<double> speeds;
  for (auto& page : pages) speeds.insert(page.get());
  EXPECT_EQ(speeds.size(), 1u);
  EXPECT_LT(*speeds.begin(), 100);
  request.mutable_timing()->set_speed(200);  // joins what runs, at a half of this, a quarter, ...
  EXPECT_EQ(server.client().open(request).resolved().timing().speed(), *speeds.begin());
}

// A page that wants to be faster closes its slow stream first.
TEST(Pace, ASpeedIsNotThatOfAFeedThatEnds) {
  TestServer server(withAdmission());
  v1::OpenStream request = pacedRequest(1, 1);  // so slow that also a busy machine has room
  request.mutable_timing()->set_duration_s(0);
  request.set_delivery(v1::DELIVERY_LIVE);
  const auto slow = server.client().open(request);
  request.mutable_timing()->set_speed(2);
  request.mutable_timing()->set_min_speed(1);
  const auto joined = server.client().open(request);
  EXPECT_EQ(joined.resolved().timing().speed(), 1);
  server.client().close(slow);
  server.client().close(joined);
  EXPECT_EQ(server.client().open(request).resolved().timing().speed(), 2);
}

TEST(Pace, WithoutAdmissionAStreamMayLag) {
  TestServer server;
  EXPECT_EQ(server.client().tryOpen(pacedRequest(1e5, 1)).code(), v1::CODE_OK);
}

TEST(Pace, MeasuringChangesNoEvent) {
  TestServer asked(withAdmission()), unasked;
  const v1::OpenStream request = pacedRequest(500, 0.02);
  const Packets one = asked.run(request)[0], other = unasked.run(request)[0];
  ASSERT_EQ(one.size(), other.size());
  std::uint64_t events = 0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].payload, other[i].payload);
    events += one[i].header.count();
    EXPECT_EQ(one[i].header.lag_ms(), 0u);
  }
  EXPECT_GT(events, 0u);
}

}  // namespace
}  // namespace saccade
