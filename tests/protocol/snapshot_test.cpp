// A stream that joins a running feed first gets the state of its pixels, and can follow them from there.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "mock/test_server.h"

namespace saccade {
namespace {

constexpr double kC = 0.3, kBias = 1e-3;

// Path tracing without a filter and without reconstruction. The change of each frame is exactly the
// difference of its pictures, and the brightness of a sensor is that of the picture.
v1::OpenStream sharedRequest(v1::EventModel model) {
  v1::OpenStream request = tinyRequest();
  request.set_delivery(v1::DELIVERY_LIVE);
  request.mutable_timing()->set_clock(v1::CLOCK_PACED);
  request.mutable_timing()->set_frame_rate_hz(50);
  request.mutable_timing()->set_duration_s(0);
  request.mutable_method()->set_name("pt");
  v1::Sensor& sensor = *request.mutable_sensors(0);
  sensor.set_threshold(kC);
  sensor.set_bias(kBias);
  sensor.set_model(model);
  sensor.set_reconstruction(v1::RECONSTRUCTION_DIRECT);
  sensor.set_max_events_per_pixel_frame(65536);
  return request;
}

std::vector<float> planeOf(const std::string& bytes) {
  std::vector<float> plane(bytes.size() / sizeof(float));
  std::memcpy(plane.data(), bytes.data(), bytes.size());
  return plane;
}

class Snapshot : public testing::TestWithParam<v1::EventModel> {
 protected:
  Snapshot() {
    early_.attach(stream_);
    early_.giveCredit(1 << 20);
    while (early_.receive()->header.t1_ns() < 100'000'000) {
    }
    late_stream_ = server_.client().open(sharedRequest(GetParam()));
    late_.attach(late_stream_);
    late_.giveCredit(std::uint64_t{1} << 30);
  }

  TestServer server_;
  const v1::StreamOpened stream_ = server_.client().open(sharedRequest(GetParam()));
  v1::StreamOpened late_stream_;
  MockSubscriber early_ = server_.dataSubscriber(), late_ = server_.dataSubscriber();
};

TEST_P(Snapshot, IsTheFirstPacketOfALateJoinerWhoCanGoOnFromThere) {
  const auto first = late_.receive();
  ASSERT_TRUE(first);
  ASSERT_EQ(first->header.kind(), v1::KIND_SNAPSHOT);
  EXPECT_EQ(first->header.seq(), 0u);
  EXPECT_GT(first->header.t0_ns(), 0);
  PacketContent content;
  ASSERT_EQ(decodePacket(first->header, first->payload, content), "");
  const bool remembers = GetParam() == v1::EVENT_MODEL_ACCUMULATING;
  EXPECT_EQ(content.pixels.brightness == content.pixels.reference, !remembers);

  auto packet = late_.receive();
  EXPECT_EQ(packet->header.seq(), 1u);
  EXPECT_EQ(packet->header.t0_ns(), first->header.t0_ns());
  if (!remembers) return;  // the events of this model say nothing about the level of a pixel
  v1::Request ask;
  ask.mutable_get_frame()->set_stream_id(late_stream_.stream_id());
  ask.mutable_get_frame()->set_token(late_stream_.token());
  const v1::FramePicture frame = server_.client().call(ask).get_frame();

  std::vector<float>& level = content.pixels.reference;
  for (; packet->header.t0_ns() < frame.t1_ns(); packet = late_.receive()) {
    PacketContent events;
    ASSERT_EQ(decodePacket(packet->header, packet->payload, events), "");
    for (const Event& e : events.events) level[e.y * 32 + e.x] += static_cast<float>(e.p ? kC : -kC);
  }
  const std::vector<float> I = planeOf(frame.intensity());
  for (std::size_t i = 0; i < level.size(); ++i) {
    EXPECT_LT(std::abs(std::log(kBias + I[i]) - level[i]), kC + 1e-3) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Models, Snapshot,
                         testing::Values(v1::EVENT_MODEL_ACCUMULATING, v1::EVENT_MODEL_PROBABILISTIC));

}  // namespace
}  // namespace saccade
