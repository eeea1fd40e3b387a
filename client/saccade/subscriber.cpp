#include "saccade/subscriber.h"

#include <iterator>
#include <utility>
#include <zmq_addon.hpp>

namespace saccade::client {
namespace {

constexpr int kTakenAtOnce = 1024;  // messages

bool takesCredit(v1::Kind kind) {
  return kind != v1::KIND_HEARTBEAT && kind != v1::KIND_ERROR;
}

}  // namespace

Subscriber::Subscriber(zmq::context_t& context, const Attachment& attachment)
    : socket_(connectSocket(context, zmq::socket_type::dealer, attachment.endpoint, attachment.keys)),
      has_topic_(false),
      credit_(attachment.credit) {
  v1::DataRequest request;
  v1::Attach& attach = *request.mutable_attach();
  attach.set_stream_id(attachment.stream_id);
  attach.set_token(attachment.token);
  attach.mutable_from_seqs()->Assign(attachment.from_seqs.begin(), attachment.from_seqs.end());
  send(request);
  giveCredit(credit_);
}

Subscriber::Subscriber(zmq::context_t& context, const std::string& endpoint,
                       const std::vector<std::string>& topics, const CurveKeys& keys)
    : socket_(connectSocket(context, zmq::socket_type::sub, endpoint, keys)), has_topic_(true) {
  for (const std::string& topic : topics) socket_.set(zmq::sockopt::subscribe, topic);
}

std::optional<DecodedPacket> Subscriber::receive(std::chrono::milliseconds timeout) {
  giveBack();
  if (arrived_.empty() && !waitReadable(socket_, timeout)) return std::nullopt;
  for (int i = 0; i < kTakenAtOnce && !endsWith(v1::KIND_ERROR) && take(); ++i) {
  }
  if (arrived_.empty()) return std::nullopt;
  Arrived arrived = std::move(arrived_.front());
  arrived_.pop_front();
  waiting_ -= arrived.cost, used_ += arrived.cost;
  DecodedPacket batch;
  batch.header = std::move(arrived.header);
  const std::string fault = decodePacket(batch.header, arrived.payload.to_string(), batch);
  if (!fault.empty()) throw StreamFault("a packet must not be used: " + fault);
  if (batch.header.kind() == v1::KIND_ERROR) {
    throw StreamRefused(arrived.payload.to_string(), !batch.header.stream_id().empty());
  }
  if (batch.header.kind() != v1::KIND_HEARTBEAT) safe_[batch.header.sensor()] = batch.header.seq();
  return batch;
}

// Takes a message from the socket, if there is one. Its queue has no bound of its own.
bool Subscriber::take() {
  std::vector<zmq::message_t> parts;
  if (!zmq::recv_multipart(socket_, std::back_inserter(parts), zmq::recv_flags::dontwait)) return false;
  const std::size_t first = has_topic_ ? 1 : 0;
  if (parts.size() != first + 2) throw StreamFault("the server sent a message that is not a packet");
  const zmq::message_t& head = parts[first];
  Arrived arrived{.header = {}, .payload = std::move(parts[first + 1]), .cost = 0};
  if (!arrived.header.ParseFromArray(head.data(), static_cast<int>(head.size()))) {
    throw StreamFault("the server sent a header that cannot be read");
  }
  if (takesCredit(arrived.header.kind())) arrived.cost = head.size() + arrived.payload.size();
  add(std::move(arrived));
  return true;
}

// The server sends while credit is above zero. A heartbeat stands for those before it.
void Subscriber::add(Arrived arrived) {
  if (arrived.header.kind() == v1::KIND_HEARTBEAT && endsWith(v1::KIND_HEARTBEAT)) arrived_.pop_back();
  if (credit_ > 0 && arrived.cost > 0 && used_ + waiting_ >= credit_)
    throw StreamFault("the server sends more than it has credit for");
  waiting_ += arrived.cost;
  arrived_.push_back(std::move(arrived));
}

bool Subscriber::endsWith(v1::Kind kind) const {
  return !arrived_.empty() && arrived_.back().header.kind() == kind;
}

void Subscriber::send(const v1::DataRequest& request) {
  socket_.send(zmq::buffer(request.SerializeAsString()), zmq::send_flags::none);
}

void Subscriber::giveCredit(std::uint64_t bytes) {
  v1::DataRequest request;
  request.mutable_credit()->set_bytes(bytes);
  send(request);
}

// Tops credit up at half, so that the server does not wait for a round trip.
void Subscriber::giveBack() {
  if (credit_ == 0 || used_ < credit_ / 2) return;
  for (const auto& [sensor, seq] : std::exchange(safe_, {})) {
    v1::DataRequest request;
    request.mutable_ack()->set_sensor(sensor);
    request.mutable_ack()->set_seq(seq);
    send(request);
  }
  giveCredit(std::exchange(used_, 0));
}

}  // namespace saccade::client
