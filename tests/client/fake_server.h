// The server's end of the data socket, played by a test: a ROUTER on a free port of loopback.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <zmq.hpp>

#include "saccade/wire/packet_cutter.h"

namespace saccade {

class FakeServer {
 public:
  explicit FakeServer(zmq::context_t& context) : socket_(context, zmq::socket_type::router) {
    socket_.set(zmq::sockopt::linger, 0);
    socket_.set(zmq::sockopt::rcvtimeo, 10000);
    socket_.set(zmq::sockopt::sndhwm, 0);
    socket_.bind("tcp://127.0.0.1:*");
  }

  std::string endpoint() const { return socket_.get(zmq::sockopt::last_endpoint); }

  // The client's next message; fails the test when nothing comes.
  template <class Message>
  Message receive() {
    Message message;
    zmq::message_t body;
    EXPECT_TRUE(socket_.recv(peer_)) << "the client said nothing";
    EXPECT_TRUE(socket_.recv(body) && message.ParseFromArray(body.data(), static_cast<int>(body.size())));
    return message;
  }
  v1::DataRequest receive() { return receive<v1::DataRequest>(); }
  bool saysNothing(std::chrono::milliseconds time) {
    zmq::pollitem_t item{socket_.handle(), 0, ZMQ_POLLIN, 0};
    return zmq::poll(&item, 1, time) == 0;
  }

  // To whoever spoke last.
  void send(const google::protobuf::Message& head) {
    zmq::message_t peer;
    peer.copy(peer_);
    socket_.send(peer, zmq::send_flags::sndmore);
    socket_.send(zmq::buffer(head.SerializeAsString()), zmq::send_flags::none);
  }
  void send(const Packet& packet) {
    zmq::message_t peer;
    peer.copy(peer_);
    socket_.send(peer, zmq::send_flags::sndmore);
    socket_.send(zmq::buffer(packet.header.SerializeAsString()), zmq::send_flags::sndmore);
    socket_.send(zmq::buffer(*packet.payload), zmq::send_flags::none);
  }

 private:
  zmq::socket_t socket_;
  zmq::message_t peer_;
};

}  // namespace saccade
