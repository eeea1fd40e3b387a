// Streams whose frames have several intervals.
#include <gtest/gtest.h>

#include "eval/metrics/window_errors.h"
#include "mock/bad_request.h"
#include "mock/control_calls.h"
#include "mock/events_of.h"

namespace saccade {
namespace {

constexpr int kFrames = 5;
constexpr double kFrame = 0.02;  // seconds

// Many intervals in each frame, and poses beside the events.
v1::OpenStream following(double px = 0.05) {
  v1::OpenStream request = tinyRequest();
  v1::Timing& timing = *request.mutable_timing();
  timing.set_frame_rate_hz(1 / kFrame);
  timing.set_duration_s(kFrames * kFrame);
  timing.set_interval_px(px);
  request.mutable_method()->set_name("irradiance_cache");
  request.add_truth()->set_name("pose");
  return request;
}

std::string bytesOf(const std::map<std::uint32_t, Packets>& packets) {
  std::string bytes;
  for (const auto& [channel, of_channel] : packets) bytes += comparableBytes(of_channel);
  return bytes;
}

TEST(Intervals, HaveTheEventsOfShortFrames) {
  TestServer server(2);
  v1::OpenStream whole = following(), coarse = whole, fine = whole;
  whole.mutable_timing()->mutable_refinement()->set_finest_px(whole.timing().interval_px());
  coarse.mutable_timing()->set_interval_px(0);
  fine.mutable_timing()->set_interval_px(0);
  fine.mutable_timing()->set_frame_rate_hz(1000);
  const auto count = [&](const v1::OpenStream& request) {
    return static_cast<double>(checkPackets(server.run(request)[0]).events);
  };
  const double events = count(whole), of_fine = count(fine), of_coarse = count(coarse);
  EXPECT_GT(of_fine, 100);
  EXPECT_LT(std::abs(events - of_fine), 0.5 * std::abs(of_coarse - of_fine));
}

// The events of frames that are as short as the pieces, with far fewer frames.
TEST(Intervals, AreRefinedWhereBrightnessChanges) {
  TestServer server(2);
  v1::OpenStream refined = following(0.8), whole = refined, fine = following(0.05);
  whole.mutable_timing()->mutable_refinement()->set_finest_px(0.8);
  fine.mutable_timing()->mutable_refinement()->set_finest_px(0.05);
  const auto events = [&](const v1::OpenStream& request) {
    const auto packets = server.run(request);
    checkPackets(packets.at(0));
    return eventsOf(packets.at(0));
  };
  const Events truth = events(fine);
  const double window_ns = 1e9 * kFrame / 4;
  const auto of_refined = eval::windowErrors(events(refined), truth, window_ns),
             of_whole = eval::windowErrors(events(whole), truth, window_ns);
  EXPECT_LT(of_refined.time, 0.5 * of_whole.time);
  EXPECT_LT(of_refined.missed_share + of_refined.false_share,
            0.5 * (of_whole.missed_share + of_whole.false_share));
}

TEST(Intervals, SayHowTheyAreRefined) {
  TestServer server;
  v1::OpenStream request = following(0.8);
  request.mutable_sensors(0)->set_threshold(0.3);
  *request.add_sensors() = request.sensors(0);
  request.mutable_sensors(1)->set_threshold_off(0.15);
  const v1::Refinement by_default = server.client().open(request).resolved().timing().refinement();
  EXPECT_EQ(by_default.finest_px(), 0.05);
  EXPECT_EQ(by_default.threshold(), 0.15);
  EXPECT_EQ(by_default.bias(), 1e-3);
  request.mutable_method()->set_name("event_svgf");
  EXPECT_EQ(server.client().open(request).resolved().timing().refinement().finest_px(), 0.8);
}

TEST(Intervals, LeaveFramesAndPacketsAsTheyAre) {
  TestServer server(2);
  const v1::StreamOpened stream = server.client().open(following());
  EXPECT_EQ(stream.frames(), static_cast<std::uint64_t>(kFrames));
  EXPECT_EQ(stream.resolved().timing().max_rate_hz(), 1000);
  auto packets = server.run(following());
  checkPackets(packets[0]);
  EXPECT_EQ(packets[0].back().header.t1_ns(), 100'000'000);
  EXPECT_EQ(packets[0].back().header.end_reason(), v1::END_REASON_FINISHED);
  EXPECT_EQ(packets[0].back().header.frame(), static_cast<std::uint64_t>(kFrames));
  for (const Received& packet : packets[0]) {
    EXPECT_LE(packet.header.t1_ns() - packet.header.t0_ns(), 5'000'000);
    if (packet.header.kind() == v1::KIND_EVENTS) {
      EXPECT_EQ(packet.header.frame(), static_cast<std::uint64_t>(packet.header.t0_ns() / 20'000'000));
    }
  }
  const TruthSamples poses = samplesOf(packets[1]);
  ASSERT_EQ(poses.size(), kFrames + 1u);
  for (std::size_t i = 0; i < poses.size(); ++i)
    EXPECT_EQ(poses[i].t_ns, static_cast<std::int64_t>(i) * 20'000'000);
}

TEST(Intervals, AreTheSameForAnyNumberOfThreads) {
  TestServer one(1), two(2);
  EXPECT_EQ(bytesOf(one.run(following())), bytesOf(two.run(following())));
}

TEST(Intervals, FollowAClientThatSteers) {
  TestServer server(2);
  v1::OpenStream request = following();
  request.mutable_timing()->set_clock(v1::CLOCK_LOCKSTEP);
  const auto stream = server.client().open(request);
  MockSubscriber subscriber = server.dataSubscriber();
  subscriber.attach(stream);
  subscriber.giveCredit(1 << 24);
  for (int i = 1; i <= kFrames; ++i) {
    const v1::Steered steered = server.client().call(steerTo(stream, 0.01 * i * i)).steer();
    EXPECT_EQ(steered.frame(), static_cast<std::uint64_t>(i));
    EXPECT_EQ(steered.t_ns(), i * 20'000'000);
  }
  const auto packets = subscriber.receiveAll(2);
  EXPECT_GT(checkPackets(packets.at(0)).events, 20u);
  const v1::OpenStream again = describe(server.client(), stream);
  EXPECT_EQ(again.timing().interval_px(), 0.05);
  EXPECT_EQ(eventsOf(packets.at(0)), eventsOf(server.run(again)[0]));
}

TEST(Intervals, RefuseWhatTheyCannotDo) {
  using Open = v1::OpenStream;
  TestServer server;
  const auto bad = [](std::function<void(Open&)> spoil, const std::string& field, const std::string& told) {
    return BadRequest{following(), std::move(spoil), v1::CODE_INVALID_ARGUMENT, field, told};
  };
  expectRefused(
      server,
      {bad([](Open& r) { r.mutable_timing()->set_interval_px(1e-3); }, "timing.interval_px", "[0.01, 1000]"),
       bad([](Open& r) { r.mutable_timing()->set_interval_px(std::nan("")); }, "timing.interval_px", "nan"),
       bad([](Open& r) { r.mutable_timing()->set_max_rate_hz(10); }, "timing.max_rate_hz", "[50, 100000]"),
       bad([](Open& r) { r.mutable_timing()->set_interval_px(0), r.mutable_timing()->set_max_rate_hz(10); },
           "timing.max_rate_hz", "interval_px"),
       bad([](Open& r) { r.add_truth()->set_name("flow_forward"); }, "truth[1].name", "interval_px"),
       bad([](Open& r) { r.mutable_timing()->mutable_refinement()->set_finest_px(0.001); },
           "timing.refinement.finest_px", "[0.0015625, 0.05]"),
       bad([](Open& r) { r.mutable_timing()->mutable_refinement()->set_threshold(11); },
           "timing.refinement.threshold", "[0.001, 10]"),
       bad([](Open& r) { r.mutable_timing()->mutable_refinement()->set_bias(std::nan("")); },
           "timing.refinement.bias", "nan"),
       bad([](Open& r) { r.mutable_timing()->set_interval_px(0), r.mutable_timing()->mutable_refinement(); },
           "timing.refinement", "interval_px"),
       bad(
           [](Open& r) {
             r.mutable_timing()->mutable_refinement()->set_finest_px(0.01);
             r.mutable_method()->set_name("svgf");
           },
           "timing.refinement.finest_px", "svgf has whole frames only"),
       bad(
           [](Open& r) {
             r.mutable_timing()->mutable_refinement()->set_finest_px(0.01);
             r.mutable_quality()->set_jitter(true);
           },
           "timing.refinement.finest_px", "jitter")});
}

}  // namespace
}  // namespace saccade
