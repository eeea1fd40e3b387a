#include "mock/mock_subscriber.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace saccade {

MockSubscriber::MockSubscriber(const std::string& data_endpoint, const MockKeys& keys)
    : socket_(context_, zmq::socket_type::dealer), broadcast_(false) {
  socket_.set(zmq::sockopt::linger, 0);
  keys.apply(socket_);
  socket_.connect(data_endpoint);
}

MockSubscriber::MockSubscriber(const std::string& broadcast_endpoint, const v1::StreamOpened& stream,
                               const MockKeys& keys)
    : socket_(context_, zmq::socket_type::sub), broadcast_(true) {
  socket_.set(zmq::sockopt::linger, 0);
  keys.apply(socket_);
  for (const auto& topic : stream.topics()) socket_.set(zmq::sockopt::subscribe, topic);
  socket_.connect(broadcast_endpoint);
}

void MockSubscriber::attach(const v1::StreamOpened& stream, const std::vector<std::uint64_t>& from_seqs) {
  v1::DataRequest request;
  request.mutable_attach()->set_stream_id(stream.stream_id());
  request.mutable_attach()->set_token(stream.token());
  request.mutable_attach()->mutable_from_seqs()->Add(from_seqs.begin(), from_seqs.end());
  sendRaw(request.SerializeAsString());
}

void MockSubscriber::giveCredit(std::uint64_t bytes) {
  v1::DataRequest request;
  request.mutable_credit()->set_bytes(bytes);
  sendRaw(request.SerializeAsString());
}

void MockSubscriber::acknowledge(std::uint32_t sensor, std::uint64_t seq) {
  v1::DataRequest request;
  request.mutable_ack()->set_sensor(sensor);
  request.mutable_ack()->set_seq(seq);
  sendRaw(request.SerializeAsString());
}

void MockSubscriber::sendRaw(const std::string& bytes) {
  socket_.send(zmq::buffer(bytes));
}

std::optional<Received> MockSubscriber::receive(std::chrono::milliseconds timeout) {
  using std::chrono::steady_clock, std::chrono::milliseconds;
  const auto end = steady_clock::now() + timeout;
  while (true) {
    const auto left = std::chrono::ceil<milliseconds>(end - steady_clock::now());
    auto packet = receiveAny(std::max(left, milliseconds(0)));
    if (!packet || packet->header.kind() != v1::KIND_HEARTBEAT) return packet;
  }
}

std::optional<Received> MockSubscriber::receiveAny(std::chrono::milliseconds timeout) {
  socket_.set(zmq::sockopt::rcvtimeo, static_cast<int>(timeout.count()));
  Received packet;
  zmq::message_t header, payload, topic;
  if (broadcast_ && !socket_.recv(topic)) return {};
  if (!socket_.recv(header) || !header.more() || !socket_.recv(payload)) return {};
  packet.topic = topic.to_string();
  packet.payload = payload.to_string();
  packet.bytes = header.size() + payload.size();
  if (!packet.header.ParseFromString(header.to_string())) throw std::runtime_error("a broken header");
  return packet;
}

std::map<std::uint32_t, Packets> MockSubscriber::receiveAll(int sensors) {
  std::map<std::uint32_t, Packets> all;
  for (int ended = 0; ended < sensors;) {
    const auto packet = receive();
    if (!packet) throw std::runtime_error("no packet came");
    if (packet->header.kind() == v1::KIND_ERROR) throw std::runtime_error(packet->payload);
    if (!broadcast_) giveCredit(packet->bytes);
    if (packet->header.kind() == v1::KIND_END) ++ended;
    all[packet->header.sensor()].push_back(*packet);
  }
  return all;
}

}  // namespace saccade
