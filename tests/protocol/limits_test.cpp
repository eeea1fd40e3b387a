// The limits of a server: each is named, and reaching it harms nobody else.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <map>

#include "app/admission/limits.h"
#include "mock/keyed_server.h"
#include "saccade/wire/protocol.h"

namespace saccade {
namespace {

Config withLimit(Limit limit, double value) {
  Config config = testConfig();
  config.limits[limit] = value;
  return config;
}

void expectReached(const v1::Status& status, Limit limit, const std::string& field) {
  EXPECT_EQ(status.code(), v1::CODE_RESOURCE_EXHAUSTED) << status.message();
  EXPECT_EQ(status.limit(), rowOf(limit).name) << status.message();
  EXPECT_EQ(status.field(), field) << status.message();
  EXPECT_NE(status.message().find(rowOf(limit).name), std::string::npos) << status.message();
}

v1::OpenStream withPoses(int keys, int csv_lines) {
  v1::OpenStream request = tinyRequest();
  std::string csv;
  for (int i = 0; i < csv_lines; ++i) csv += std::to_string(i) + " 0 0 0 0 0 0 1\n";
  if (csv_lines > 0) request.mutable_trajectory()->set_csv(csv);
  for (int i = 0; i < keys; ++i) {
    v1::Keyframe& key = *request.mutable_trajectory()->mutable_keyframes()->add_keys();
    key.set_time_s(i);
    key.mutable_rotation()->set_w(1);
  }
  return request;
}

// The camera has some, and an object others.
v1::OpenStream withObjectPoses(int keys, int csv_lines) {
  v1::OpenStream request = withPoses(keys, 0);
  v1::ObjectMotion& object = *request.add_objects();
  object.set_name("tall_block");
  object.mutable_path()->set_csv(withPoses(0, csv_lines).trajectory().csv());
  return request;
}

TEST(Limits, TheGridOfAMethodCountsAsMemory) {
  TestServer server(withLimit(Limit::kMemory, 8));
  v1::OpenStream request = tinyRequest();
  expectReached(server.client().tryOpen(request), Limit::kMemory, "view");
  (*request.mutable_method()->mutable_params())["memory_mib"] = 1;
  EXPECT_EQ(server.client().tryOpen(request).code(), v1::CODE_OK);
}

// Room for one stream of tinyRequest() and not for a second, which may come later.
TEST(Limits, OneMoreThanAllMayHaveIsRefused) {
  const struct {
    Limit limit;
    double value;
    std::string field;
  } all[]{{Limit::kStreams, 1, ""},
          {Limit::kSensors, 1, "sensors"},
          {Limit::kPixels, 32 * 24 * 1.5, "view"},
          {Limit::kMemory, 13, "view"},  // of 8.5 each
          {Limit::kQueues, 20, ""}};     // of 16 each
  for (const auto& [limit, value, field] : all) {
    TestServer server(withLimit(limit, value));
    server.client().open(tinyRequest());
    const v1::Status status = server.client().tryOpen(tinyRequest());
    expectReached(status, limit, field);
    EXPECT_GT(status.retry_after_s(), 0);
  }
}

TEST(Limits, ARequestThatExceedsALimitAloneIsNotWorthARetry) {
  v1::OpenStream many = tinyRequest();
  many.add_sensors();
  v1::OpenStream rows = tinyRequest();  // 500 Hz
  for (int i = 0; i < 2; ++i) {
    rows.add_truth()->set_name("imu");
    rows.mutable_truth(i)->mutable_imu()->set_rate_hz(5000);
  }
  const struct {
    Limit limit;
    double value;
    v1::OpenStream request;
    std::string field;
  } all[]{{Limit::kPixels, 700, tinyRequest(), "view"},
          {Limit::kSensors, 1, many, "sensors"},
          {Limit::kRows, 19, rows, "truth"},
          {Limit::kFrameRate, 499, tinyRequest(), "timing.frame_rate_hz"},
          {Limit::kTrajectoryPoints, 3, withPoses(4, 0), "trajectory.keyframes.keys"},
          {Limit::kTrajectoryPoints, 3, withPoses(0, 4), "trajectory.csv"},
          {Limit::kTrajectoryPoints, 3, withObjectPoses(2, 2), "objects"}};
  for (const auto& [limit, value, request, field] : all) {
    TestServer server(withLimit(limit, value));
    const v1::Status status = server.client().tryOpen(request);
    expectReached(status, limit, field);
    EXPECT_EQ(status.retry_after_s(), 0);
  }
  TestServer server(withLimit(Limit::kTrajectoryPoints, 4));
  EXPECT_EQ(server.client().tryOpen(withPoses(4, 0)).code(), v1::CODE_OK);
  EXPECT_EQ(server.client().tryOpen(withPoses(0, 4)).code(), v1::CODE_OK);
  EXPECT_EQ(server.client().tryOpen(withObjectPoses(2, 2)).code(), v1::CODE_OK);
  TestServer just(withLimit(Limit::kRows, 20));
  EXPECT_EQ(just.client().tryOpen(rows).code(), v1::CODE_OK);
}

TEST(Limits, APlaceIsFreeAgainOnceItsStreamIsOver) {
  TestServer server(withLimit(Limit::kStreams, 1));
  const auto stream = server.client().open(tinyRequest());
  MockSubscriber subscriber = server.dataSubscriber();
  subscriber.attach(stream);
  subscriber.giveCredit(1 << 20);
  subscriber.receiveAll(1);
  expectReached(server.client().tryOpen(tinyRequest()), Limit::kStreams, "");
  server.client().close(stream);
  const auto deadline = ChangeNotifier::Clock::now() + kPatience;
  auto code = v1::CODE_UNSPECIFIED;
  while (code != v1::CODE_OK && ChangeNotifier::Clock::now() < deadline)
    code = server.client().tryOpen(tinyRequest()).code();
  EXPECT_EQ(code, v1::CODE_OK);
}

class ClientLimits : public KeyedServer {};

TEST_F(ClientLimits, BindOneClientAndNoOther) {
  const struct {
    Limit limit;
    double value;
    std::string field;
  } all[]{{Limit::kClientStreams, 1, ""},
          {Limit::kClientSensors, 1, "sensors"},
          {Limit::kClientPixels, 32 * 24, "view"}};
  for (const auto& [limit, value, field] : all) {
    Config config = config_;
    config.limits[limit] = value;
    TestServer server(config, alice_);
    MockClient bob(server.app().controlEndpoint(), bob_);
    server.client().open(tinyRequest());
    const v1::Status status = server.client().tryOpen(tinyRequest());
    expectReached(status, limit, field);
    EXPECT_EQ(status.retry_after_s(), 0);  // she has to end one herself
    EXPECT_EQ(bob.tryOpen(tinyRequest()).code(), v1::CODE_OK);
  }
}

TEST(Limits, ThoseOfOneClientBindNobodyWithoutKeys) {
  TestServer server(withLimit(Limit::kClientStreams, 1));
  for (int i = 0; i < 2; ++i) EXPECT_EQ(server.client().tryOpen(tinyRequest()).code(), v1::CODE_OK);
}

// A thousand at once. Every one is answered, no more are opened than there are places, and who was there
// before goes on.
TEST(Limits, AFloodOfStartsIsRefused) {
  constexpr int kRequests = 1000, kPlaces = 6;
  Config config = withLimit(Limit::kStreams, kPlaces);
  config.limits[Limit::kRequests] = 4;
  TestServer server(config);
  v1::OpenStream request = tinyRequest();
  request.mutable_timing()->set_duration_s(0.2);
  const auto stream = server.client().open(request);
  MockSubscriber subscriber = server.dataSubscriber();
  subscriber.attach(stream);
  subscriber.giveCredit(1 << 20);

  zmq::context_t context;
  zmq::socket_t flood(context, zmq::socket_type::dealer);
  flood.set(zmq::sockopt::linger, 0);
  flood.set(zmq::sockopt::rcvtimeo, static_cast<int>(kPatience.count()));
  for (const auto queue : {ZMQ_SNDHWM, ZMQ_RCVHWM}) {
    const int none = 0;
    zmq_setsockopt(flood.handle(), queue, &none, sizeof none);
  }
  flood.connect(server.app().controlEndpoint());
  v1::Request start;
  start.set_protocol_version(kProtocolVersion);
  *start.mutable_open_stream() = tinyRequest();
  for (int i = 0; i < kRequests; ++i) flood.send(zmq::buffer(start.SerializeAsString()));
  std::map<std::string, int> answers;  // by limit
  for (int i = 0; i < kRequests; ++i) {
    zmq::message_t message;
    v1::Reply reply;
    ASSERT_TRUE(flood.recv(message)) << "after " << i << " replies";
    ASSERT_TRUE(reply.ParseFromString(message.to_string()));
    ++answers[reply.status().limit()];
    EXPECT_EQ(reply.has_open_stream(), reply.status().limit().empty());
    EXPECT_EQ(reply.status().retry_after_s(), reply.has_open_stream() ? 0 : kRetrySeconds);
  }
  EXPECT_GE(answers[""], 1);
  EXPECT_LE(answers[""], kPlaces - 1);
  EXPECT_GT(answers["requests"], 0);
  EXPECT_EQ(answers[""] + answers["requests"] + answers["streams"], kRequests);
  EXPECT_EQ(checkPackets(subscriber.receiveAll(1)[0]).end_ns, 200'000'000);
}

// A client that asks and does not read must not fill the server's memory with pictures.
TEST(Limits, PicturesComeAtTheirRate) {
  TestServer server(withLimit(Limit::kPictures, 1));
  v1::OpenStream request = tinyRequest();
  request.mutable_view()->set_width(128);
  request.mutable_view()->set_height(256);  // 1/4 MiB
  request.mutable_method()->set_name("pt");
  request.mutable_quality()->set_bounces(0);
  request.mutable_timing()->set_duration_s(0.006);
  const auto stream = server.client().open(request);
  MockSubscriber subscriber = server.dataSubscriber();
  subscriber.attach(stream);
  subscriber.giveCredit(1 << 30);
  subscriber.receiveAll(1);
  v1::Request look;
  look.mutable_get_frame()->set_stream_id(stream.stream_id());
  look.mutable_get_frame()->set_token(stream.token());
  const auto began = ChangeNotifier::Clock::now();
  v1::Status status = server.client().call(look).status();
  int given = 0;
  for (; status.code() == v1::CODE_OK; ++given) status = server.client().call(look).status();
  EXPECT_GE(given, 5);  // a second's worth, and one
  expectReached(status, Limit::kPictures, "");
  EXPECT_GT(status.retry_after_s(), 0);
  EXPECT_LE(status.retry_after_s(), 0.25);
  while (status.code() != v1::CODE_OK) {
    ASSERT_LT(ChangeNotifier::Clock::now() - began, kPatience);
    status = server.client().call(look).status();
  }
  EXPECT_GE(ChangeNotifier::Clock::now() - began,
            given * std::chrono::milliseconds(250) - std::chrono::seconds(1));
}

TEST(Limits, ARequestThatIsTooLongEndsItsConnectionOnly) {
  TestServer server(withLimit(Limit::kMessage, 1));
  MockClient verbose(server.app().controlEndpoint());
  verbose.setPatience(std::chrono::milliseconds(300));
  EXPECT_THROW(verbose.callRaw(std::string((1 << 20) + 1, 'x')), std::runtime_error);
  EXPECT_EQ(server.client().server().threads(), 1u);
}

// By limit; those that are not told are absent.
std::map<std::string, double> usedOf(TestServer& server) {
  std::map<std::string, double> used;
  const auto description = server.client().server();
  for (const auto& limit : description.limits())
    if (limit.has_used()) used[limit.name()] = limit.used();
  return used;
}

TEST(Limits, TheServerTellsWhatIsUsedOfThem) {
  TestServer server(withLimit(Limit::kCpu, 85));
  auto used = usedOf(server);
  for (const auto& [name, amount] : used) EXPECT_EQ(amount, 0) << name;
  for (const char* name : {"cpu", "viewers", "bakes"}) EXPECT_EQ(used.count(name), 1u) << name;
  for (const char* name : {"client-streams", "queue", "pictures"}) EXPECT_EQ(used.count(name), 0u) << name;

  v1::OpenStream request = tinyRequest();
  request.add_sensors();
  request.add_sensors();
  const auto stream = server.client().open(request);
  used = usedOf(server);
  EXPECT_EQ(used["streams"], 1);
  EXPECT_EQ(used["sensors"], 3);
  EXPECT_EQ(used["pixels"], 32 * 24);
  EXPECT_EQ(used["queues"], 16);
  EXPECT_GT(used["memory"], 8);
  EXPECT_EQ(used["requests"], 0);
  EXPECT_EQ(used["cpu"], 0);  // it is not PACED

  request = tinyRequest();
  request.mutable_timing()->set_clock(v1::CLOCK_PACED);
  request.mutable_timing()->set_speed(0.01);
  const auto paced = server.client().open(request);
  used = usedOf(server);
  EXPECT_EQ(used["streams"], 2);
  EXPECT_GT(used["cpu"], 0);
  EXPECT_GT(used["scenes"], 0);

  for (const auto& one : {stream, paced}) server.client().close(one);
  server.client().open(tinyRequest());  // makes room by those that are over
  EXPECT_EQ(usedOf(server)["streams"], 1);
}

TEST(Limits, TheServerListsThemAndTheProtocolExplainsThem) {
  TestServer server(withLimit(Limit::kStreams, 5));
  std::map<std::string, double> told;
  const auto description = server.client().server();
  for (const auto& limit : description.limits()) told[limit.name()] = limit.value();
  EXPECT_EQ(told.size(), kLimitTable.size());
  EXPECT_EQ(told["streams"], 5);
  EXPECT_EQ(told["queue"], 4);
  std::ifstream file(SACCADE_SOURCE_DIR "/proto/PROTOCOL.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  for (const auto& [name, value] : told) EXPECT_NE(page.find("`" + name + "`"), std::string::npos) << name;
  for (const LimitRow& row : kLimitTable) EXPECT_EQ(&row, &rowOf(row.limit)) << row.name;
}

}  // namespace
}  // namespace saccade
