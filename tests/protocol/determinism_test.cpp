// The same resolved request gives the same bytes, whatever the threads, the other clients or the timing.
#include <gtest/gtest.h>

#include "mock/test_server.h"

namespace saccade {
namespace {

std::string bytesOf(TestServer& server, const v1::OpenStream& request) {
  auto packets = server.run(request);
  std::string bytes;
  for (const auto& [sensor, of_sensor] : packets) bytes += comparableBytes(of_sensor);
  return bytes;
}

v1::OpenStream twoSensors() {
  v1::OpenStream request = tinyRequest();
  request.add_sensors()->set_model(v1::EVENT_MODEL_PROBABILISTIC);
  return request;
}

TEST(Determinism, ThreadsAndRunsDoNotMatter) {
  TestServer one(1), two(2);
  const std::string bytes = bytesOf(one, twoSensors());
  EXPECT_EQ(bytes, bytesOf(one, twoSensors()));
  EXPECT_EQ(bytes, bytesOf(two, twoSensors()));
  v1::OpenStream other = twoSensors();
  other.set_seed(8);
  EXPECT_NE(bytes, bytesOf(one, other));
}

TEST(Determinism, OtherClientsDoNotMatter) {
  TestServer server(2);
  const std::string alone = bytesOf(server, twoSensors());
  v1::OpenStream endless = tinyRequest();
  endless.set_delivery(v1::DELIVERY_LIVE);
  endless.mutable_timing()->set_duration_s(0);
  const auto stream = server.client().open(endless);
  MockSubscriber neighbour = server.dataSubscriber();
  neighbour.attach(stream);
  neighbour.giveCredit(std::uint64_t{1} << 30);
  ASSERT_TRUE(neighbour.receive());
  EXPECT_EQ(alone, bytesOf(server, twoSensors()));
}

}  // namespace
}  // namespace saccade
