#include "stream/control_server.h"

#include <gtest/gtest.h>

#include <future>

#include "mock/mock_client.h"

namespace saccade {
namespace {

constexpr std::int64_t kMaxBytes = 1 << 20;

// An answer that takes its time, as a scene that is being loaded does, keeps nobody else waiting.
TEST(ControlServer, ASlowAnswerDelaysNoOther) {
  RequestCounts counts;
  ControlServer server("tcp://127.0.0.1:*", kMaxBytes, counts);
  std::promise<ControlServer::Answer> slow;
  server.start([&](const v1::Request& request, const std::string&, ControlServer::Answer answer) {
    if (request.has_open_stream()) return slow.set_value(std::move(answer));
    v1::Reply reply;
    reply.mutable_server_info()->set_version("quick");
    answer(std::move(reply));
  });
  MockClient patient(server.endpoint()), hasty(server.endpoint());
  auto opened = std::async(std::launch::async, [&] { return patient.tryOpen({}); });
  const ControlServer::Answer answer = slow.get_future().get();  // the server has it
  EXPECT_EQ(hasty.server().version(), "quick");
  v1::Reply late;
  *late.mutable_status() = makeStatus(v1::CODE_UNAVAILABLE, "late");
  answer(late);
  EXPECT_EQ(opened.get().message(), "late");
}

// The message cites scene files and their names.
TEST(ControlServer, AStatusCanBeReadWhateverItsMessageCites) {
  const v1::Status status = makeStatus(v1::CODE_UNAVAILABLE, "x\xFF" + std::string(1 << 20, '\xC3'));
  EXPECT_TRUE(v1::Status().ParseFromString(status.SerializeAsString()));
  EXPECT_LT(status.ByteSizeLong(), 5000u);
}

TEST(ControlServer, AnEndpointInUseIsNamed) {
  RequestCounts counts;
  ControlServer first("tcp://127.0.0.1:*", kMaxBytes, counts);
  const std::string endpoint = first.endpoint();
  try {
    ControlServer second(endpoint, kMaxBytes, counts);
    FAIL();
  } catch (const std::runtime_error& fault) {
    EXPECT_NE(std::string(fault.what()).find(endpoint), std::string::npos);
  }
}

}  // namespace
}  // namespace saccade
