#include "web/viewer_stream.h"

#include <iterator>
#include <vector>
#include <zmq_addon.hpp>

#include "web/viewer_json.h"

namespace saccade {
namespace {

constexpr std::size_t kReadAtOnce = 64;  // packets; then the others of this viewer have their turn

std::string frameOf(const zmq::message_t& header, const zmq::message_t& payload) {
  const auto size = static_cast<std::uint32_t>(header.size());
  std::string frame;
  frame.reserve(sizeof size + header.size() + payload.size());
  frame.append(reinterpret_cast<const char*>(&size), sizeof size);
  frame.append(header.to_string_view());
  frame.append(payload.to_string_view());
  return frame;
}

}  // namespace

ViewerStream::ViewerStream(zmq::context_t& context, const Source& source, const v1::Attach& attach)
    : socket_(client::connectSocket(context, zmq::socket_type::dealer, source.data, source.keys)),
      attached_(std::in_place, context, socket_),
      has_credit_(true) {
  v1::DataRequest request;
  *request.mutable_attach() = attach;
  send(request);
  giveCredit(kCredit);
}

ViewerStream::ViewerStream(zmq::context_t& context, const Source& source, const v1::Subscribe& subscribe)
    : socket_(client::connectSocket(context, zmq::socket_type::sub, source.broadcast, source.keys)),
      has_credit_(false) {
  socket_.set(zmq::sockopt::subscribe,
              "s/" + subscribe.stream_id() + "/" + std::to_string(subscribe.sensor()) + "/");
}

void ViewerStream::forwardTo(WebSocket* viewer) {
  std::vector<zmq::message_t> parts;
  for (std::size_t i = 0; i < kReadAtOnce; ++i) {
    parts.clear();
    if (!zmq::recv_multipart(socket_, std::back_inserter(parts), zmq::recv_flags::dontwait)) return;
    if (parts.size() < 2) continue;
    const zmq::message_t &header = parts[parts.size() - 2], &payload = parts.back();
    if (has_credit_) used_ += header.size() + payload.size();
    note(header);
    if (!viewer || refused_ || !(has_credit_ || !viewer->full())) continue;
    if (payload.size() > kMostPayload) {
      refuse(*viewer, payload.size());
      continue;
    }
    const std::string frame = frameOf(header, payload);
    parts.clear();  // the page's queue takes a copy
    viewer->sendBinary(frame);
  }
}

void ViewerStream::refuse(WebSocket& viewer, std::size_t bytes) {
  refused_ = ended_ = true;
  v1::Reply reply;
  reply.mutable_status()->set_code(v1::CODE_RESOURCE_EXHAUSTED);
  reply.mutable_status()->set_message("a packet of " + std::to_string(bytes) + " bytes exceeds " +
                                      std::to_string(kMostPayload) + ", the most that a page is sent");
  viewer.sendText(toJson(reply));
}

void ViewerStream::note(const zmq::message_t& header) {
  v1::PacketHeader packet;
  if (!packet.ParseFromArray(header.data(), static_cast<int>(header.size()))) return;
  ended_ = ended_ || packet.kind() == v1::KIND_END || packet.kind() == v1::KIND_ERROR;
}

void ViewerStream::giveBack() {
  if (used_ < kCredit / 4) return;
  giveCredit(used_);
  used_ = 0;
}

void ViewerStream::send(const v1::DataRequest& request) {
  socket_.send(zmq::buffer(request.SerializeAsString()), zmq::send_flags::dontwait);
}

void ViewerStream::giveCredit(std::uint64_t bytes) {
  v1::DataRequest request;
  request.mutable_credit()->set_bytes(bytes);
  send(request);
}

}  // namespace saccade
