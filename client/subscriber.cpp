#include "client/subscriber.h"

#include <iterator>
#include <utility>
#include <zmq_addon.hpp>

namespace saccade::client {

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

std::optional<Batch> Subscriber::receive(std::chrono::milliseconds timeout) {
  giveBack();
  std::vector<zmq::message_t> parts;
  if (!waitReadable(socket_, timeout)) return std::nullopt;
  if (!zmq::recv_multipart(socket_, std::back_inserter(parts), zmq::recv_flags::dontwait))
    return std::nullopt;
  const std::size_t first = has_topic_ ? 1 : 0;
  if (parts.size() != first + 2) throw StreamFault("the server sent a message that is not a packet");
  const zmq::message_t &head = parts[first], &payload = parts[first + 1];
  Batch batch;
  if (!batch.header.ParseFromArray(head.data(), static_cast<int>(head.size()))) {
    throw StreamFault("the server sent a header that cannot be read");
  }
  const std::string fault = decodePacket(batch.header, payload.to_string(), batch);
  if (!fault.empty()) throw StreamFault("a packet must not be used: " + fault);
  if (batch.header.kind() == v1::KIND_ERROR) {
    throw StreamRefused(payload.to_string(), !batch.header.stream_id().empty());
  }
  if (batch.header.kind() != v1::KIND_HEARTBEAT) {
    used_ += head.size() + payload.size();
    safe_[batch.header.sensor()] = batch.header.seq();
  }
  return batch;
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
