// Streams whose client sends the frames.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "mock/bad_request.h"
#include "mock/control_calls.h"
#include "mock/events_of.h"

namespace saccade {
namespace {

constexpr int kWidth = 6, kHeight = 4, kPixels = kWidth * kHeight;
constexpr double kRate = 100, kThreshold = 0.1, kStep = 0.23;  // step: of log brightness, in each frame
constexpr std::int64_t kFrameNs = 10'000'000;

v1::OpenStream pushed(int frames) {
  v1::OpenStream request;
  request.set_pushed(true);
  request.mutable_view()->set_width(kWidth);
  request.mutable_view()->set_height(kHeight);
  request.mutable_timing()->set_frame_rate_hz(kRate);
  request.mutable_timing()->set_duration_s(frames / kRate);
  v1::Sensor& sensor = *request.add_sensors();
  sensor.set_threshold(kThreshold);
  sensor.set_bias(1e-12);
  return request;
}

// All pixels are 1, but pixel (1, 0) is `value`.
v1::Request frameOf(const v1::StreamOpened& stream, float value) {
  std::vector<float> plane(kPixels, 1.0f);
  plane[1] = value;
  v1::Request request;
  forStream(*request.mutable_push_frame(), stream)
      .set_intensity(std::string(reinterpret_cast<const char*>(plane.data()), kPixels * sizeof(float)));
  return request;
}

float ramp(int frame) {
  return static_cast<float>(std::exp(kStep * frame));
}

// The pixel starts at some level between its thresholds, and crosses one in each of equal times.
void expectRamp(const Events& events, int frames) {
  constexpr double kBetween = kThreshold / kStep * kFrameNs;
  ASSERT_FALSE(events.empty());
  EXPECT_LT(events.front().t_ns, 2 * kBetween);
  EXPECT_GT(events.back().t_ns + kBetween, frames * kFrameNs);
  for (std::size_t i = 0; i < events.size(); ++i) {
    EXPECT_EQ(events[i].x, 1);
    EXPECT_EQ(events[i].y, 0);
    EXPECT_EQ(events[i].p, 1);
    EXPECT_NEAR(events[i].t_ns - events.front().t_ns, i * kBetween, 2000);
  }
}

class Pushed : public testing::Test {
 protected:
  v1::StreamOpened open(const v1::OpenStream& request) {
    const v1::StreamOpened stream = server_.client().open(request);
    subscriber_.attach(stream);
    subscriber_.giveCredit(1 << 24);
    return stream;
  }
  v1::Reply call(const v1::Request& request) { return server_.client().call(request); }

  // Sends the ramp, and waits for the events of each frame.
  Packets sendRamp(const v1::StreamOpened& stream, int frames) {
    Packets packets;
    for (int i = 0; i <= frames; ++i) {
      const v1::Reply reply = call(frameOf(stream, ramp(i)));
      EXPECT_EQ(reply.push_frame().frame(), static_cast<std::uint64_t>(i)) << reply.ShortDebugString();
      EXPECT_EQ(reply.push_frame().t_ns(), i * kFrameNs);
      while (i > 0 && (packets.empty() || packets.back().header.t1_ns() < i * kFrameNs)) {
        auto packet = subscriber_.receive();
        if (!packet) throw std::runtime_error("no packet");
        packets.push_back(std::move(*packet));
      }
    }
    return packets;
  }

  TestServer server_{2};
  MockSubscriber subscriber_ = server_.dataSubscriber();
};

TEST_F(Pushed, MakesTheEventsOfAKnownRamp) {
  const auto stream = open(pushed(4));
  EXPECT_EQ(stream.resolved().sensors(0).reconstruction(), v1::RECONSTRUCTION_DIRECT);
  EXPECT_TRUE(stream.resolved().timing().packet_per_frame());
  EXPECT_EQ(stream.frames(), 4u);
  expectRamp(eventsOf(sendRamp(stream, 4)), 4);
  EXPECT_EQ(subscriber_.receive()->header.end_reason(), v1::END_REASON_FINISHED);
  EXPECT_EQ(call(frameOf(stream, 1)).status().code(), v1::CODE_NOT_FOUND);
}

TEST_F(Pushed, AClosedStreamHasAllEventsOfItsFrames) {
  v1::OpenStream request = pushed(1);
  request.mutable_timing()->set_duration_s(0);
  const auto stream = open(request);
  expectRamp(eventsOf(sendRamp(stream, 3)), 3);
  server_.client().close(stream);
  EXPECT_EQ(subscriber_.receive()->header.end_reason(), v1::END_REASON_CLOSED);
}

TEST_F(Pushed, TheTruthIsWhatWasSent) {
  v1::OpenStream request = pushed(2);
  request.add_truth()->set_name("intensity");
  const auto stream = open(request);
  for (int i = 0; i <= 2; ++i) call(frameOf(stream, ramp(i)));
  std::string planes;
  for (const TruthSample& sample : samplesOf(subscriber_.receiveAll(2)[1])) planes += sample.elements;
  std::string sent;
  for (int i = 0; i <= 2; ++i) sent += frameOf(stream, ramp(i)).push_frame().intensity();
  EXPECT_EQ(planes, sent);
}

TEST_F(Pushed, BoundsTheFramesThatWait) {
  const auto stream = server_.client().open(pushed(100));  // nobody receives
  for (int i = 0; i <= 4; ++i) EXPECT_EQ(call(frameOf(stream, 1)).status().code(), v1::CODE_OK) << i;
  const v1::Status full = call(frameOf(stream, 1)).status();
  EXPECT_EQ(full.code(), v1::CODE_RESOURCE_EXHAUSTED);
  EXPECT_EQ(full.limit(), "pushes");
  EXPECT_GT(full.retry_after_s(), 0);
  v1::Request bad = frameOf(stream, -1);
  EXPECT_EQ(call(bad).status().limit(), "pushes") << "it was read, though there is no room for it";
  bad.mutable_push_frame()->clear_intensity();
  EXPECT_EQ(call(bad).status().limit(), "pushes");
}

TEST_F(Pushed, RefusesBadFrames) {
  const auto stream = open(pushed(5)), other = server_.client().open(tinyRequest());
  const auto expect = [&](const v1::Request& request, v1::Code code, const std::string& field) {
    const v1::Status status = call(request).status();
    EXPECT_EQ(status.code(), code) << status.ShortDebugString();
    EXPECT_EQ(status.field(), field) << status.ShortDebugString();
  };
  v1::Request stranger = frameOf(stream, 1), shorter = frameOf(stream, 1);
  stranger.mutable_push_frame()->set_token("0");
  shorter.mutable_push_frame()->mutable_intensity()->pop_back();
  expect(stranger, v1::CODE_PERMISSION_DENIED, "token");
  expect(shorter, v1::CODE_INVALID_ARGUMENT, "intensity");
  for (const float value :
       {-1e-6f, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()})
    expect(frameOf(stream, value), v1::CODE_INVALID_ARGUMENT, "intensity[1]");
  expect(frameOf(other, 1), v1::CODE_INVALID_ARGUMENT, "stream_id");
  EXPECT_EQ(call(frameOf(stream, 1)).push_frame().frame(), 0u);  // none of them counts
}

TEST_F(Pushed, RefusesWhatOnlyASceneHas) {
  using Open = v1::OpenStream;
  const auto bad = [](std::function<void(Open&)> spoil, const std::string& field, const std::string& told) {
    return BadRequest{pushed(5), std::move(spoil), v1::CODE_INVALID_ARGUMENT, field, told};
  };
  expectRefused(
      server_,
      {bad([](Open& r) { r.set_scene("cornell-box"); }, "scene", "unset"),
       bad([](Open& r) { r.mutable_trajectory()->set_name("right"); }, "trajectory", "unset"),
       bad([](Open& r) { r.mutable_method()->set_spp(2); }, "method", "unset"),
       bad([](Open& r) { r.mutable_quality()->set_bounces(1); }, "quality", "unset"),
       bad([](Open& r) { r.add_further_views(); }, "further_views", "unset"),
       bad([](Open& r) { r.set_animation("Run"); }, "animation", "unset"),
       bad([](Open& r) { r.mutable_view()->set_fov_x_deg(40); }, "view.fov_x_deg", "unset"),
       bad([](Open& r) { r.mutable_timing()->set_clock(v1::CLOCK_PACED); }, "timing.clock", "unset"),
       bad([](Open& r) { r.mutable_timing()->set_steerable(true); }, "timing.steerable", "unset"),
       bad([](Open& r) { r.add_truth()->set_name("depth"); }, "truth[0].name", "intensity, brightness"),
       bad([](Open& r) { r.add_truth()->set_name("dept"); }, "truth[0].name", "no truth channel"),
       bad([](Open& r) { r.mutable_sensors(0)->set_from_event(1); }, "sensors[0].from_event", "scene"),
       bad([](Open& r) { r.mutable_view()->set_width(4096), r.mutable_view()->set_height(513); }, "view",
           "2097152")});
}

}  // namespace
}  // namespace saccade
