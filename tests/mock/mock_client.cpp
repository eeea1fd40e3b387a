#include "mock/mock_client.h"

#include <stdexcept>

#include "saccade/wire/protocol.h"

namespace saccade {

MockClient::MockClient(const std::string& control_endpoint, const MockKeys& keys)
    : socket_(context_, zmq::socket_type::dealer) {
  socket_.set(zmq::sockopt::linger, 0);
  setPatience(kPatience);
  keys.apply(socket_);
  socket_.connect(control_endpoint);
}

void MockClient::setPatience(std::chrono::milliseconds patience) {
  socket_.set(zmq::sockopt::rcvtimeo, static_cast<int>(patience.count()));
}

v1::Reply MockClient::call(v1::Request request) {
  request.set_request_id(++request_id_);
  request.set_protocol_version(kProtocolVersion);
  v1::Reply reply = callRaw(request.SerializeAsString());
  if (reply.request_id() != request_id_) throw std::runtime_error("a reply to another request");
  return reply;
}

v1::Reply MockClient::callRaw(const std::string& bytes) {
  socket_.send(zmq::buffer(bytes));
  zmq::message_t part;
  v1::Reply reply;
  if (!socket_.recv(part) || !reply.ParseFromString(part.to_string())) throw std::runtime_error("no reply");
  return reply;
}

v1::StreamOpened MockClient::open(const v1::OpenStream& stream) {
  v1::Request request;
  *request.mutable_open_stream() = stream;
  const v1::Reply reply = call(request);
  if (reply.status().code() != v1::CODE_OK) throw std::runtime_error(reply.ShortDebugString());
  return reply.open_stream();
}

v1::Status MockClient::tryOpen(const v1::OpenStream& stream) {
  v1::Request request;
  *request.mutable_open_stream() = stream;
  return call(request).status();
}

v1::Status MockClient::close(const v1::StreamOpened& stream) {
  v1::Request request;
  request.mutable_close_stream()->set_stream_id(stream.stream_id());
  request.mutable_close_stream()->set_token(stream.token());
  return call(request).status();
}

v1::StreamList MockClient::streams() {
  v1::Request request;
  request.mutable_list_streams();
  return call(request).list_streams();
}

v1::StreamInfo MockClient::info(const std::string& stream_id) {
  const v1::StreamList list = streams();
  for (const auto& info : list.streams()) {
    if (info.stream_id() == stream_id) return info;
  }
  return {};
}

v1::ServerDescription MockClient::server() {
  v1::Request request;
  request.mutable_server_info();
  return call(request).server_info();
}

}  // namespace saccade
