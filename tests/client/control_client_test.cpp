#include "saccade/control_client.h"

#include <gtest/gtest.h>

#include <future>

#include "fake_server.h"

namespace saccade::client {
namespace {

// Answers one request: `early` other replies first, then one with `status`.
std::future<v1::Request> answer(FakeServer& server, int early, v1::Status status) {
  return std::async(std::launch::async, [&server, early, status] {
    const auto request = server.receive<v1::Request>();
    v1::Reply reply;
    for (int i = 1; i <= early; ++i) {
      reply.set_request_id(request.request_id() + i);
      server.send(reply);
    }
    reply.set_request_id(request.request_id());
    *reply.mutable_status() = status;
    reply.mutable_server_info()->set_version("1.2.3");
    server.send(reply);
    return request;
  });
}

v1::Status statusOf(v1::Code code, const std::string& message = {}, const std::string& field = {}) {
  v1::Status status;
  status.set_code(code);
  status.set_message(message);
  status.set_field(field);
  return status;
}

v1::Request infoRequest() {
  v1::Request request;
  request.mutable_server_info();
  return request;
}

TEST(ControlClient, ReplyIsMatchedByItsId) {
  zmq::context_t context;
  FakeServer server(context);
  ControlClient client(context, server.endpoint());
  auto request = answer(server, 2, statusOf(v1::CODE_OK));
  EXPECT_EQ(client.call(infoRequest(), std::chrono::seconds(10)).server_info().version(), "1.2.3");
  EXPECT_EQ(request.get().protocol_version(), 1u);
}

TEST(ControlClient, ANoticeArrivesThoughTheClientIsGone) {
  zmq::context_t context;
  FakeServer server(context);
  ControlClient(context, server.endpoint()).tell(infoRequest());
  EXPECT_EQ(server.receive<v1::Request>().protocol_version(), 1u);
}

TEST(ControlClient, TheReplyToANoticeIsSkipped) {
  zmq::context_t context;
  FakeServer server(context);
  ControlClient client(context, server.endpoint());
  client.tell(infoRequest());
  const auto told = answer(server, 0, statusOf(v1::CODE_NOT_FOUND)).get().request_id();
  auto request = answer(server, 0, statusOf(v1::CODE_OK));
  EXPECT_EQ(client.call(infoRequest(), std::chrono::seconds(10)).server_info().version(), "1.2.3");
  EXPECT_EQ(request.get().request_id(), told + 1);
}

// The list also names an opening of somebody else.
TEST(ControlClient, TellsWhatTheServerDoesForALongCall) {
  zmq::context_t context;
  FakeServer server(context);
  ControlClient client(context, server.endpoint());
  const auto done = std::async(std::launch::async, [&server] {
    const auto open = server.receive<v1::Request>(), list = server.receive<v1::Request>();
    EXPECT_TRUE(list.has_list_streams());
    v1::Reply reply;
    reply.set_request_id(list.request_id());
    for (const auto& [id, text] :
         {std::pair{open.request_id() + 7, "another"}, {open.request_id(), "baking"}}) {
      v1::OpeningInfo& opening = *reply.mutable_list_streams()->add_opening();
      opening.set_request_id(id), opening.set_doing(text);
    }
    server.send(reply);
    v1::Reply opened;
    opened.set_request_id(open.request_id());
    *opened.mutable_status() = statusOf(v1::CODE_OK);
    opened.mutable_open_stream()->set_stream_id("s");
    server.send(opened);
  });
  v1::Request request;
  request.mutable_open_stream();
  std::vector<std::string> told;
  const v1::Reply reply =
      client.call(request, std::chrono::seconds(10), {},
                  [&](const v1::OpeningInfo& opening) { told.push_back(opening.doing()); });
  EXPECT_EQ(reply.open_stream().stream_id(), "s");
  EXPECT_EQ(told, std::vector<std::string>{"baking"});
}

TEST(ControlClient, ARefusalNamesTheField) {
  zmq::context_t context;
  FakeServer server(context);
  ControlClient client(context, server.endpoint());
  auto request =
      answer(server, 0, statusOf(v1::CODE_INVALID_ARGUMENT, "must be above 0", "sensors[1].threshold"));
  try {
    client.call(infoRequest(), std::chrono::seconds(10));
    FAIL() << "no refusal";
  } catch (const Refused& refused) {
    EXPECT_EQ(refused.code, v1::CODE_INVALID_ARGUMENT);
    EXPECT_STREQ(refused.what(), "sensors[1].threshold: must be above 0");
  }
}

TEST(ControlClient, ARefusalWithoutWordsIsTold) {
  for (const int code : {0, 99}) {
    zmq::context_t context;
    FakeServer server(context);
    ControlClient client(context, server.endpoint());
    auto request = answer(server, 0, statusOf(static_cast<v1::Code>(code)));
    try {
      client.call(infoRequest(), std::chrono::seconds(10));
      FAIL() << "no refusal";
    } catch (const Refused& refused) {
      EXPECT_EQ(refused.what(), "refused with status " + std::to_string(code) + ", without a reason");
    }
  }
}

TEST(ControlClient, AReplyWithoutTheResultOfItsCallIsTold) {
  zmq::context_t context;
  FakeServer server(context);
  ControlClient client(context, server.endpoint());
  auto request = answer(server, 0, statusOf(v1::CODE_OK));  // with the result of server_info
  try {
    client.call(listStreams(), std::chrono::seconds(10));
    FAIL() << "a reply";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(),
              "the server at " + server.endpoint() + " sent a reply without the result of the call");
  }
}

// As another server does that has taken the place of the one that was asked.
TEST(ControlClient, AServerThatNoLongerKnowsOfALongCallEndsIt) {
  zmq::context_t context;
  FakeServer server(context);
  ControlClient client(context, server.endpoint());
  const auto done = std::async(std::launch::async, [&server] {
    server.receive<v1::Request>();
    for (int i = 0; i < 3; ++i) {
      v1::Reply reply;
      reply.set_request_id(server.receive<v1::Request>().request_id());
      reply.mutable_list_streams();
      server.send(reply);
    }
  });
  v1::Request request;
  request.mutable_open_stream();
  try {
    client.call(request, std::chrono::minutes(1), {}, [](const v1::OpeningInfo&) {});
    FAIL() << "a reply";
  } catch (const Refused& refused) {
    EXPECT_EQ(refused.code, v1::CODE_UNAVAILABLE);
    EXPECT_EQ(refused.field, "");
  }
}

TEST(ControlClient, SilenceEndsAtTheDeadlineAndSaysWhatToDo) {
  zmq::context_t context;
  FakeServer server(context);
  ControlClient client(context, server.endpoint());
  try {
    client.call(infoRequest(), std::chrono::milliseconds(20));
    FAIL() << "an answer from nobody";
  } catch (const NoAnswer& error) {
    EXPECT_NE(std::string(error.what()).find("no saccaded answers at " + server.endpoint()),
              std::string::npos);
  }
}

// As the data socket does.
TEST(ControlClient, AnAnswerOfTwoPartsIsNotOfAControlSocket) {
  zmq::context_t context;
  FakeServer server(context);
  ControlClient client(context, server.endpoint());
  const auto packet = std::async(std::launch::async, [&server] {
    server.receive<v1::Request>();
    server.send(makeErrorPacket("", "attach first"));
  });
  try {
    client.call(infoRequest(), std::chrono::seconds(10));
    FAIL() << "a reply";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(), server.endpoint() + " is not a control socket; is it the data port?");
  }
}

// As of a server that cut its text within a character.
TEST(ControlClient, AReplyThatCannotBeReadEndsTheWait) {
  zmq::context_t context;
  FakeServer server(context);
  ControlClient client(context, server.endpoint());
  auto request = answer(server, 0, statusOf(v1::CODE_INVALID_ARGUMENT, "'\xC3"));
  try {
    client.call(infoRequest(), std::chrono::seconds(10));
    FAIL() << "a reply";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(), "the server at " + server.endpoint() + " sent a reply that cannot be read");
  }
}

TEST(ControlClient, ARequestThatTheServerCannotReadIsRefused) {
  zmq::context_t context;
  FakeServer server(context);
  ControlClient client(context, server.endpoint());
  const auto refusal = std::async(std::launch::async, [&server] {
    server.receive<v1::Request>();
    v1::Reply reply;  // without an id: the server knows of none
    *reply.mutable_status() = statusOf(v1::CODE_INVALID_ARGUMENT, "a request is one part");
    server.send(reply);
  });
  EXPECT_THROW(client.call(infoRequest(), std::chrono::seconds(10)), Refused);
}

TEST(ControlClient, ATextThatIsNoUtf8IsNotSent) {
  zmq::context_t context;
  ControlClient client(context, "tcp://127.0.0.1:1");
  v1::Request request = infoRequest();
  request.mutable_open_stream()->set_scene("\xFF");
  EXPECT_THROW(client.call(request, std::chrono::seconds(10)), std::invalid_argument);
}

TEST(ControlClient, NonsenseIsNoEndpoint) {
  zmq::context_t context;
  EXPECT_THROW(ControlClient(context, "nonsense"), std::invalid_argument);
}

TEST(ReachableEndpoint, WildcardsBecomeTheHostOfTheControlSocket) {
  const std::string control = "tcp://render7:5770";
  EXPECT_EQ(reachableEndpoint("tcp://0.0.0.0:5771", control), "tcp://render7:5771");
  EXPECT_EQ(reachableEndpoint("tcp://*:5771", control), "tcp://render7:5771");
  EXPECT_EQ(reachableEndpoint("tcp://[::]:5771", control), "tcp://render7:5771");
  EXPECT_EQ(reachableEndpoint("tcp://10.0.0.1:5771", control), "tcp://10.0.0.1:5771");
  EXPECT_EQ(reachableEndpoint("ipc:///run/data", control), "ipc:///run/data");
}

}  // namespace
}  // namespace saccade::client
