// A server's control socket that announces another data endpoint, as of a proxy in front of it.
#pragma once

#include <atomic>
#include <string>
#include <thread>
#include <zmq.hpp>

#include "saccade/v1/control.pb.h"

namespace saccade {

class ControlRelay {
 public:
  ControlRelay(const std::string& control_endpoint, std::string data_endpoint)
      : data_endpoint_(std::move(data_endpoint)) {
    client_side_.set(zmq::sockopt::linger, 0);
    client_side_.bind("tcp://127.0.0.1:*");
    endpoint_ = client_side_.get(zmq::sockopt::last_endpoint);
    server_side_.set(zmq::sockopt::linger, 0);
    server_side_.connect(control_endpoint);
    thread_ = std::thread([this] { run(); });
  }
  ~ControlRelay() {
    stop_ = true;
    thread_.join();
  }
  ControlRelay(const ControlRelay&) = delete;
  ControlRelay& operator=(const ControlRelay&) = delete;

  const std::string& endpoint() const { return endpoint_; }

 private:
  void run() {
    zmq::pollitem_t items[]{{client_side_.handle(), 0, ZMQ_POLLIN, 0},
                            {server_side_.handle(), 0, ZMQ_POLLIN, 0}};
    while (!stop_) {
      zmq::poll(items, 2, std::chrono::milliseconds(20));
      if (items[0].revents != 0) forwardRequest();
      if (items[1].revents != 0) forwardReply();
    }
  }
  // There is one client: its connection is that of the newest request.
  void forwardRequest() {
    zmq::message_t request;
    if (!client_side_.recv(peer_) || !client_side_.recv(request)) return;
    server_side_.send(request, zmq::send_flags::none);
  }
  void forwardReply() {
    zmq::message_t message, peer;
    v1::Reply reply;
    if (!server_side_.recv(message)) return;
    reply.ParseFromArray(message.data(), static_cast<int>(message.size()));
    if (reply.has_server_info()) reply.mutable_server_info()->set_data_endpoint(data_endpoint_);
    peer.copy(peer_);
    client_side_.send(peer, zmq::send_flags::sndmore);
    client_side_.send(zmq::buffer(reply.SerializeAsString()), zmq::send_flags::none);
  }

  const std::string data_endpoint_;
  std::string endpoint_;
  zmq::context_t context_;
  zmq::socket_t client_side_{context_, zmq::socket_type::router};
  zmq::socket_t server_side_{context_, zmq::socket_type::dealer};
  zmq::message_t peer_;
  std::atomic<bool> stop_ = false;
  std::thread thread_;
};

}  // namespace saccade
