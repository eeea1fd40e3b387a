#include "saccade/stream_handle.h"

#include "saccade/opened_check.h"
#include "saccade/retry.h"
#include "saccade/stream_fault.h"

namespace saccade::client {

StreamHandle::StreamHandle(ControlClient& control, const v1::OpenStream& request, const OpenPolicy& policy)
    : control_(control) {
  retry([&](auto) { open(request, kOpenDeadline, policy.waiting, policy.watching); },
        {.until = std::chrono::steady_clock::now() + policy.retry_time,
         .waiting = policy.waiting,
         .mayPass = isRestart,
         .failed = policy.away});
}

StreamHandle::~StreamHandle() {
  close();
}

void StreamHandle::reopen(const std::vector<std::uint64_t>& from_items, std::chrono::milliseconds deadline,
                          const Waiting& waiting) {
  v1::OpenStream request = opened_.resolved();
  auto from = from_items.begin();
  for (v1::Sensor& sensor : *request.mutable_sensors()) sensor.set_from_event(*from++);
  for (v1::Truth& truth : *request.mutable_truth()) truth.set_from_sample(*from++);
  open(request, deadline, waiting);
}

// Asks for server_info first, with a short deadline: the long one is for a server that is there.
void StreamHandle::open(const v1::OpenStream& stream, std::chrono::milliseconds deadline,
                        const Waiting& waiting, const Watching& watching) {
  v1::Request info, request;
  info.mutable_server_info();
  server_ = control_.call(std::move(info), ControlClient::kDeadline, waiting).server_info();
  if (!opened_.stream_id().empty()) tellClose();
  *request.mutable_open_stream() = stream;
  v1::Reply reply = control_.call(std::move(request), deadline, waiting, watching);
  checkOpened(reply.open_stream(), stream);
  opened_ = std::move(*reply.mutable_open_stream());
}

void StreamHandle::close() {
  if (!closed_) tellClose();
  closed_ = true;
}

void StreamHandle::closeKnown() {
  if (closed_) return;
  try {
    last_info_ = info();
  } catch (const std::runtime_error&) {
    // The stream can end without it.
  }
  close();
}

void StreamHandle::tellClose() {
  v1::Request request;
  request.mutable_close_stream()->set_stream_id(opened_.stream_id());
  request.mutable_close_stream()->set_token(opened_.token());
  try {
    control_.tell(std::move(request));
  } catch (const zmq::error_t&) {
    // A signal interrupted it. The server forgets streams without a receiver by itself.
  }
}

Subscriber StreamHandle::subscribe(zmq::context_t& context,
                                   const std::vector<std::uint64_t>& from_seqs) const {
  const bool broadcast = delivery() == v1::DELIVERY_BROADCAST;
  const std::string& announced = broadcast ? server_.broadcast_endpoint() : server_.data_endpoint();
  const std::string endpoint = reachableEndpoint(announced, control_.endpoint());
  const CurveKeys& keys = control_.keys();
  try {
    if (broadcast)
      return Subscriber(context, endpoint, {opened_.topics().begin(), opened_.topics().end()}, keys);
    return Subscriber(context, {.endpoint = endpoint,
                                .stream_id = opened_.stream_id(),
                                .token = opened_.token(),
                                .from_seqs = from_seqs,
                                .keys = keys});
  } catch (const std::invalid_argument& fault) {
    throw StreamFault(std::string("the server announces an endpoint for packets that is none: ") +
                      fault.what());
  }
}

std::optional<v1::StreamInfo> StreamHandle::info(const Waiting& waiting) {
  if (last_info_) return last_info_;
  const v1::Reply reply = control_.call(listStreams(), ControlClient::kDeadline, waiting);
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

v1::FramePushed StreamHandle::push(std::span<const float> intensity) {
  v1::Request request;
  v1::PushFrame& frame = *request.mutable_push_frame();
  frame.set_stream_id(opened_.stream_id());
  frame.set_token(opened_.token());
  frame.set_intensity(intensity.data(), intensity.size_bytes());
  return control_.call(std::move(request)).push_frame();
}

v1::Steered StreamHandle::steer(v1::Steer call) {
  call.set_stream_id(opened_.stream_id());
  call.set_token(opened_.token());
  v1::Request request;
  *request.mutable_steer() = std::move(call);
  return control_.call(std::move(request)).steer();
}

}  // namespace saccade::client
