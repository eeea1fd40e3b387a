// A client in C++ that steers objects: StreamHandle of the client's library against a server.
#include <gtest/gtest.h>

#include <cstring>

#include "objects.h"
#include "saccade/subscription.h"

namespace saccade {
namespace {

constexpr int kFrames = 3;

v1::OpenStream lockstep() {
  v1::OpenStream request = stillRequest();
  request.mutable_timing()->set_clock(v1::CLOCK_LOCKSTEP);
  request.mutable_timing()->set_frame_rate_hz(100);
  request.mutable_timing()->set_duration_s(kFrames * 0.01);
  addObject(request, "tall_block").mutable_still();
  request.add_truth()->set_name("object_poses");
  return request;
}

v1::Steer moveTo(const std::string& object, double x) {
  v1::Steer call;
  v1::SteeredObject& moved = *call.add_objects();
  moved.set_name(object);
  moved.mutable_pose()->mutable_position()->set_x(x);
  moved.mutable_pose()->mutable_rotation()->set_w(1);
  return call;
}

// Where the object is at each frame of the batches.
void addPlaces(const DecodedPacket& batch, std::vector<double>& places) {
  for (const TruthSample& row : batch.truth)
    std::memcpy(&places.emplace_back(), row.elements.data() + sizeof(double), sizeof(double));
}

class SteeredHandle : public testing::Test {
 protected:
  TestServer server_;
  zmq::context_t context_;
  client::ControlClient control_{context_, server_.app().controlEndpoint()};
};

TEST_F(SteeredHandle, MovesAnObjectInEachFrame) {
  client::StreamHandle stream(control_, lockstep());
  client::Subscription subscription(context_, stream, {});
  for (int i = 1; i <= kFrames; ++i) {
    const v1::Steered at = stream.steer(moveTo("tall_block", 2 + 0.25 * i));
    EXPECT_EQ(at.frame(), static_cast<std::uint64_t>(i));
    EXPECT_EQ(at.t_ns(), i * 10'000'000);
  }
  std::vector<double> places;
  for (int ended = 0; ended < 2;) {  // the sensor, and the channel of truth
    const auto batch = subscription.receive(kPatience);
    ASSERT_TRUE(batch);
    addPlaces(*batch, places);
    ended += batch->header.kind() == v1::KIND_END;
  }
  ASSERT_EQ(places.size(), std::size_t{kFrames + 1});
  for (std::size_t i = 1; i <= kFrames; ++i) EXPECT_EQ(places[i], 2 + 0.25 * static_cast<double>(i));
}

TEST_F(SteeredHandle, TellsWhichObjectsThereAre) {
  client::StreamHandle stream(control_, lockstep());
  try {
    stream.steer(moveTo("teapot", 0));
    FAIL();
  } catch (const client::Refused& refusal) {
    EXPECT_EQ(refusal.code, v1::CODE_NOT_FOUND);
    EXPECT_EQ(refusal.field, "objects[0].name");
    EXPECT_NE(refusal.message.find("it has: tall_block"), std::string::npos) << refusal.message;
  }
}

}  // namespace
}  // namespace saccade
