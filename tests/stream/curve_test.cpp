// The list of keys, and the door it opens: closed to everything else, also where a part of the lock is
// missing.
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "mock/mock_keys.h"
#include "stream/curve_probe.h"
#include "stream/zap_handler.h"

namespace saccade {
namespace {

class Curve : public testing::Test {
 protected:
  Curve() { list(client_.public_key + " alice\n"); }
  ~Curve() override { std::remove(file_.c_str()); }

  void list(const std::string& text) const { std::ofstream(file_) << text; }
  std::shared_ptr<ClientKeys> clients() const { return std::make_shared<ClientKeys>(file_); }
  // The parts of a request of libzmq's.
  std::vector<std::string> request(const std::string& mechanism, const std::string& key) const {
    std::string bytes(32, '\0');
    zmq_z85_decode(reinterpret_cast<std::uint8_t*>(bytes.data()), key.c_str());
    return {"1.0", "7", "saccade", "127.0.0.1", "", mechanism, bytes};
  }
  // Binds; returns the endpoint.
  std::string bind(zmq::socket_t& socket) const {
    socket.set(zmq::sockopt::linger, 0);
    socket.bind("tcp://127.0.0.1:*");
    return socket.get(zmq::sockopt::last_endpoint);
  }

  const MockKeys server_ = makeMockKeys();
  const MockKeys client_ = makeMockKeys(server_.public_key), stranger_ = makeMockKeys(server_.public_key);
  const std::string file_ =
      testing::TempDir() + testing::UnitTest::GetInstance()->current_test_info()->name() + ".keys";
};

TEST_F(Curve, AListHoldsKeysNamesAndRemarks) {
  list("# who may come\n\n" + client_.public_key + " alice\n  " + stranger_.public_key + "\n");
  EXPECT_EQ(clients()->size(), 2u);
  EXPECT_TRUE(clients()->allow(client_.public_key));
  EXPECT_FALSE(clients()->allow(server_.public_key));
  EXPECT_FALSE(clients()->allow(""));
}

TEST_F(Curve, ALineMayNameItsClientAndMakeItAnAdmin) {
  list(client_.public_key + " alice admin # of the lab\n" + stranger_.public_key + "\tbob # no more\n" +
       server_.public_key + " # nobody\n");
  const auto found = [keys = clients()](const MockKeys& who) { return keys->find(who.public_key); };
  EXPECT_EQ(found(client_).name, "alice");
  EXPECT_TRUE(found(client_).admin);
  EXPECT_EQ(found(stranger_).name, "bob");
  EXPECT_FALSE(found(stranger_).admin);
  EXPECT_EQ(found(server_).name, "");
  EXPECT_EQ(found(makeMockKeys()).name, "");
}

TEST_F(Curve, WhatALineCannotSayIsAFault) {
  const std::string key = client_.public_key;
  for (const auto& [text, fault] :
       {std::pair{key + " admin\n", "the word admin comes after a name"},
        {key + " alice amdin\n", "comes the word admin"},
        {key + " alice admin too\n", "comes the word admin"},
        {key + " " + std::string(65, 'a') + "\n", "at most 64 bytes"},
        {key + " a\x1B[31m\n", "without control characters"},
        {key + " a\xff\n", "bytes of UTF-8"},
        {"# one\n" + key + " a\n" + key + " b\n", ":3: the key is in the list twice"}}) {
    list(text);
    try {
      clients();
      ADD_FAILURE() << text;
    } catch (const std::runtime_error& told) {
      EXPECT_NE(std::string(told.what()).find(fault), std::string::npos) << told.what();
    }
  }
}

// The counts of a name that stays go on, and keys of one name share them.
TEST_F(Curve, NamesKeepTheirCountsWhenTheListIsReadAgain) {
  list(client_.public_key + " alice\n" + stranger_.public_key + " alice\n" + server_.public_key + "\n");
  const auto keys = clients();
  keys->countsOf(client_.public_key)->refusals += 2;
  EXPECT_EQ(keys->countsOf(stranger_.public_key)->refusals, 2u);
  EXPECT_EQ(keys->countsOf(server_.public_key), nullptr);
  list(stranger_.public_key + " alice\n" + client_.public_key + " bob\n");
  keys->reload();
  ASSERT_EQ(keys->counts().size(), 2u);
  EXPECT_EQ(keys->counts().at("alice")->refusals, 2u);
  EXPECT_EQ(keys->counts().at("bob")->refusals, 0u);
}

// '#' is a digit of Z85.
TEST_F(Curve, AKeyMayBeginWithAHash) {
  const std::string key = "#" + std::string(39, 'a');
  list(key + "\n");
  EXPECT_TRUE(clients()->allow(key));
}

TEST_F(Curve, AFaultyListNamesTheLineAndChangesNothing) {
  const auto keys = clients();
  list(stranger_.public_key + "\nalice\n");
  try {
    keys->reload();
    FAIL();
  } catch (const std::runtime_error& fault) {
    EXPECT_EQ(std::string(fault.what()).find(file_ + ":2: "), 0u) << fault.what();
  }
  EXPECT_TRUE(keys->allow(client_.public_key));
  EXPECT_FALSE(keys->allow(stranger_.public_key));
  EXPECT_THROW(ClientKeys(file_ + ".none"), std::runtime_error);
}

TEST_F(Curve, TheHandlerSaysYesToAListedKeyOnly) {
  using Parts = std::vector<std::string>;
  const Parts yes = answerZap(request("CURVE", client_.public_key), *clients());
  EXPECT_EQ(yes, (Parts{"1.0", "7", "200", "OK", client_.public_key, ""}));
  Parts long_key = request("CURVE", client_.public_key), version = long_key;
  long_key[6] += "x";
  version[0] = "2.0";
  const Parts null{"1.0", "7", "saccade", "127.0.0.1", "", "NULL"};
  for (const Parts& no : {request("CURVE", stranger_.public_key), request("PLAIN", client_.public_key),
                          long_key, version, null, Parts{}, Parts{"1.0"}}) {
    EXPECT_EQ(answerZap(no, *clients()).at(2), "400");
    EXPECT_EQ(answerZap(no, *clients()).at(4), "");
  }
}

TEST_F(Curve, OnlyAListedKeyComesIn) {
  zmq::context_t context;
  const ZapHandler handler(context, clients());
  zmq::socket_t socket(context, zmq::socket_type::router);
  secureServer(socket, server_.secret);
  const std::string endpoint = bind(socket);
  EXPECT_EQ(handshake(endpoint, client_), ZMQ_EVENT_HANDSHAKE_SUCCEEDED);
  EXPECT_EQ(handshake(endpoint, stranger_), ZMQ_EVENT_HANDSHAKE_FAILED_AUTH);
  EXPECT_NE(handshake(endpoint, {}, 1000), ZMQ_EVENT_HANDSHAKE_SUCCEEDED);  // without CURVE
  MockKeys elsewhere = client_;
  elsewhere.server = stranger_.public_key;
  EXPECT_NE(handshake(endpoint, elsewhere, 1000), ZMQ_EVENT_HANDSHAKE_SUCCEEDED);
  EXPECT_NO_THROW(probeRefusal(zmq::socket_type::dealer, endpoint, server_.secret));
}

TEST_F(Curve, WithoutAHandlerNobodyComesIn) {
  zmq::context_t context;
  zmq::socket_t socket(context, zmq::socket_type::router);
  secureServer(socket, server_.secret);
  const std::string endpoint = bind(socket);
  EXPECT_NE(handshake(endpoint, client_, 1000), ZMQ_EVENT_HANDSHAKE_SUCCEEDED);
  EXPECT_THROW(probeRefusal(zmq::socket_type::dealer, endpoint, server_.secret), std::runtime_error);
}

// The default of libzmq: CURVE without a handler lets any key in.
TEST_F(Curve, TheProbeFindsADoorThatIsOpen) {
  zmq::context_t context;
  zmq::socket_t socket(context, zmq::socket_type::router);
  socket.set(zmq::sockopt::curve_server, true);
  socket.set(zmq::sockopt::curve_secretkey, server_.secret);
  EXPECT_THROW(probeRefusal(zmq::socket_type::dealer, bind(socket), server_.secret), std::runtime_error);
}

}  // namespace
}  // namespace saccade
