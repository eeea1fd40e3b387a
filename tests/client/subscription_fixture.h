// Both ends of a server, played by a test, and a client that receives from them.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <future>

#include "fake_server.h"
#include "saccade/subscription.h"

namespace saccade::client {

using std::chrono::milliseconds;

class SubscriptionTest : public testing::Test {
 protected:
  // The server's part. Answers requests on control until a stream is opened, as `stream`, and returns that
  // request. `lie` changes the reply.
  using Lie = std::function<void(v1::StreamOpened&)>;
  v1::OpenStream open(
      const std::string& stream, std::uint64_t epoch = 0, const Lie& lie = [](v1::StreamOpened&) {}) {
    while (true) {
      const auto request = answerNext(stream, epoch, lie);
      if (request.has_open_stream() || testing::Test::HasFailure()) return request.open_stream();
    }
  }
  v1::Request answerNext(
      const std::string& stream, std::uint64_t epoch, const Lie& lie = [](v1::StreamOpened&) {}) {
    const auto request = control_.receive<v1::Request>();
    v1::Reply reply;
    reply.set_request_id(request.request_id());
    reply.mutable_status()->set_code(v1::CODE_OK);
    if (request.has_list_streams()) reply.mutable_list_streams();  // it knows of none
    if (request.has_server_info()) reply.mutable_server_info()->set_data_endpoint(data_.endpoint());
    if (request.has_open_stream()) {
      v1::StreamOpened& opened = *reply.mutable_open_stream();
      opened.set_stream_id(stream);
      opened.set_epoch(epoch);
      opened.set_frames(20);
      *opened.mutable_resolved() = request.open_stream();
      lie(opened);
    }
    if (!request.has_close_stream()) control_.send(reply);
    return request;
  }
  v1::Attach attached() {
    v1::DataRequest request;
    while (!request.has_attach() && !testing::Test::HasFailure()) request = data_.receive();
    return request.attach();
  }
  void send(const std::vector<Packet>& packets, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i <= last; ++i) data_.send(packets.at(i));
  }

  // The client's part: its batches until END, while the server does `script`.
  void record(const std::function<void()>& script,
              Subscription::RetryPolicy retry_policy = {.retry_time = milliseconds(5000)}) {
    auto server = std::async(std::launch::async, script);
    retry_policy.silence = milliseconds(500);
    ControlClient control(context_, control_.endpoint());
    StreamHandle stream(control, request_);
    Subscription subscription(context_, stream, retry_policy);
    for (bool ended = false; !ended;) {
      const auto batch = subscription.receive(milliseconds(1000));
      if (!batch) continue;
      if (batch->header.kind() == v1::KIND_HEARTBEAT) {
        EXPECT_TRUE(subscription.catchingUp());
        ++heartbeats_;
        continue;
      }
      EXPECT_FALSE(subscription.catchingUp());
      EXPECT_EQ(batch->header.first_event_index(), events_.size() + subscription.losses().events);
      EXPECT_EQ(batch->header.count(), batch->events.size());
      events_.insert(events_.end(), batch->events.begin(), batch->events.end());
      suppressed_ += batch->header.suppressed();
      ended = batch->header.kind() == v1::KIND_END;
    }
    losses_ = subscription.losses();
  }
  std::string faultOf(const std::function<void()>& script,
                      const Subscription::RetryPolicy& retry_policy = {.retry_time = milliseconds(5000)}) {
    try {
      record(script, retry_policy);
    } catch (const std::runtime_error& fault) {
      return fault.what();
    }
    return "no fault";
  }

  zmq::context_t context_;
  FakeServer control_{context_}, data_{context_};
  v1::OpenStream request_ = [] {
    v1::OpenStream request;
    request.set_delivery(v1::DELIVERY_LOSSLESS);
    request.mutable_view()->set_width(346);
    request.mutable_view()->set_height(260);
    request.mutable_timing()->set_frame_rate_hz(1000);
    request.add_sensors()->set_threshold(0.25);
    return request;
  }();
  Events events_;
  Losses losses_;
  std::uint64_t suppressed_ = 0;
  int heartbeats_ = 0;
};

}  // namespace saccade::client
