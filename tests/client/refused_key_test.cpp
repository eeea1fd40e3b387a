// A client whose key the server refuses, or has taken off its list, learns so.
#include "mock/keyed_server.h"
#include "saccade/server_probe.h"
#include "saccade/stream_handle.h"
#include "saccade/subscription.h"

namespace saccade::client {
namespace {

class RefusedKey : public KeyedServer {
 protected:
  CurveKeys keysOf(const MockKeys& keys) const { return {keys.secret, keys.server}; }
  // The fault of a call.
  static std::string faultOf(ControlClient& control, std::chrono::milliseconds deadline = kPatience) {
    try {
      control.call(listStreams(), deadline);
    } catch (const Refused& refused) {
      EXPECT_EQ(refused.code, v1::CODE_PERMISSION_DENIED);
      return refused.what();
    } catch (const NoAnswer& silence) {
      return explainSilence(silence);
    }
    return "none";
  }
  zmq::context_t context_;
};

TEST_F(RefusedKey, IsToldAtOnceAndAgain) {
  TestServer server(config_, alice_);
  const std::string endpoint = server.app().controlEndpoint();
  ControlClient stranger(context_, endpoint, keysOf(makeMockKeys(server_.public_key)));
  for (int i = 0; i < 2; ++i) {
    const std::string fault = faultOf(stranger);
    EXPECT_NE(fault.find("the server at " + endpoint + " refuses your key"), std::string::npos) << fault;
  }
  v1::OpenStream request = tinyRequest();
  EXPECT_THROW(StreamHandle(stranger, request, {.retry_time = std::chrono::minutes(10)}), Refused);
}

TEST_F(RefusedKey, AnotherServerKeyIsSilence) {
  TestServer server(config_, alice_);
  ControlClient control(context_, server.app().controlEndpoint(), {alice_.secret, bob_.public_key});
  const std::string fault = faultOf(control, std::chrono::milliseconds(300));
  EXPECT_NE(fault.find("is your key on its list, and --server-key its public key?"), std::string::npos)
      << fault;
}

// Its stream cannot go on either.
TEST_F(RefusedKey, IsToldWhenItIsTakenOffTheList) {
  TestServer server(config_, alice_);
  ControlClient control(context_, server.app().controlEndpoint(), keysOf(bob_));
  v1::OpenStream request = tinyRequest();
  request.mutable_timing()->set_duration_s(0);
  StreamHandle stream(control, request);
  Subscription subscription(context_, stream, {});
  ASSERT_TRUE(subscription.receive(kPatience));
  allow({alice_});
  server.app().reloadKeys();
  EXPECT_EQ(faultOf(control), kRevokedKey);
  try {
    while (subscription.receive(kPatience)) {
    }
    FAIL() << "silence";
  } catch (const Refused& refused) {
    EXPECT_STREQ(refused.what(), kRevokedKey);
  }
}

}  // namespace
}  // namespace saccade::client
