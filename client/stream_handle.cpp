#include "client/stream_handle.h"

namespace saccade {

StreamHandle::StreamHandle(ControlClient& control, const v1::OpenStream& wish) : control_(control) {
  v1::Request request;
  *request.mutable_open_stream() = wish;
  opened_ = control_.call(std::move(request), kOpenDeadline).open_stream();
}

StreamHandle::~StreamHandle() {
  close();
}

void StreamHandle::close() {
  if (closed_) return;
  closed_ = true;
  v1::Request request;
  request.mutable_close_stream()->set_stream_id(opened_.stream_id());
  request.mutable_close_stream()->set_token(opened_.token());
  try {
    control_.tell(std::move(request));
  } catch (const zmq::error_t&) {
    // A signal came first: the server forgets by itself what nobody receives.
  }
}

Subscriber StreamHandle::subscribe(zmq::context_t& context, const v1::ServerDescription& server) const {
  if (opened_.resolved().delivery() == v1::DELIVERY_BROADCAST) {
    const auto endpoint = reachableEndpoint(server.broadcast_endpoint(), control_.endpoint());
    return Subscriber(context, endpoint, {opened_.topics().begin(), opened_.topics().end()}, control_.keys());
  }
  const auto endpoint = reachableEndpoint(server.data_endpoint(), control_.endpoint());
  return Subscriber(context,
                    {endpoint, opened_.stream_id(), opened_.token(), Subscriber::kCredit, control_.keys()});
}

std::optional<v1::StreamInfo> StreamHandle::info() {
  v1::Request request;
  request.mutable_list_streams();
  const v1::Reply reply = control_.call(std::move(request));
  for (const v1::StreamInfo& stream : reply.list_streams().streams()) {
    if (stream.stream_id() == opened_.stream_id()) return stream;
  }
  return std::nullopt;
}

v1::FramePicture StreamHandle::picture() {
  v1::Request request;
  request.mutable_get_frame()->set_stream_id(opened_.stream_id());
  request.mutable_get_frame()->set_token(opened_.token());
  return control_.call(std::move(request)).get_frame();
}

}  // namespace saccade
