#include "app/service.h"

#include "app/request/push_request.h"
#include "app/request/refusal.h"
#include "app/request/request_bounds.h"
#include "app/request/request_memory.h"
#include "app/streams/frame_picture.h"
#include "app/streams/stream_control.h"
#include "base/mebibyte.h"

namespace saccade {
namespace {

std::string refusalText(const v1::Status& status) {
  return "refused: " + (status.field().empty() ? "" : status.field() + ": ") + status.message();
}

v1::Reply pictureReply(const Stream& stream) {
  v1::Reply reply;
  try {
    const auto newest = stream.feed->newest().copy();
    if (!newest) throw Refusal(v1::CODE_UNAVAILABLE, {}, "the stream has no frame yet");
    *reply.mutable_get_frame() = drawPicture(*newest, stream.request->sensors(0).bias());
    *reply.mutable_status() = okStatus();
  } catch (...) {
    reply.Clear();
    *reply.mutable_status() = statusOfException();
  }
  return reply;
}

v1::Reply descriptionReply(const Stream& stream) {
  v1::Reply reply;
  try {
    *reply.mutable_describe_stream() = describeStream(stream);
    *reply.mutable_status() = okStatus();
  } catch (...) {
    reply.Clear();
    *reply.mutable_status() = statusOfException();
  }
  return reply;
}

}  // namespace

Service::Service(const SceneCache& scenes, ResourceQuota& quota, StreamRegistry& streams,
                 StreamOpener& opener, ClientLog& log, DescribeServer describe_server)
    : quota_(quota),
      streams_(streams),
      opener_(opener),
      log_(log),
      describe_server_(std::move(describe_server)),
      scenes_(scenes) {}

void Service::handle(RawRequest request, const Peer& peer, Answer answer) {
  const auto give = [&log = log_, user = peer.user, answer](v1::Reply reply) {
    if (reply.status().code() != v1::CODE_OK) log.info(user, refusalText(reply.status()));
    answer(std::move(reply));
  };
  const Answer tell(give, [answer](std::size_t bytes) { answer.expect(bytes); });
  try {
    dispatch(std::move(request), peer, tell);
  } catch (...) {
    v1::Reply refusal;
    *refusal.mutable_status() = statusOfException();
    tell(std::move(refusal));
  }
}

// Hands the request to the part that answers it. Throws what is to be answered instead.
void Service::dispatch(RawRequest raw, const Peer& peer, const Answer& answer) {
  if (raw.call == v1::Request::kOpenStream) return open(std::move(raw), peer, answer);
  if (raw.call == v1::Request::kPushFrame) return push(raw, answer);
  const v1::Request request = parseRequest(raw.message.bytes);
  if (request.has_list_scenes()) return scenes_.ask(answer);
  if (request.has_get_frame()) return getFrame(request.get_frame(), answer);
  if (request.has_describe_stream()) return describe(request.describe_stream(), answer);
  v1::Reply reply;
  fill(request, peer, reply);
  *reply.mutable_status() = okStatus();
  answer(std::move(reply));
}

void Service::open(RawRequest request, const Peer& peer, Answer answer) {
  auto slot = quota_.take(
      peer.user, {{Limit::kRequests, 1}, {Limit::kMemory, openingMemory(request.message.bytes.size())}});
  opener_.open(std::move(request), peer, [answer = std::move(answer), slot](v1::Reply reply) mutable {
    slot.reset();  // before the answer: its client may send the next request at once
    answer(std::move(reply));
  });
}

// Without the registry's lock: a frame may be large.
void Service::push(const RawRequest& raw, const Answer& answer) {
  const PushRequest request = readPush(raw.message.bytes);
  PushTarget target;
  streams_.with(request.stream_id, request.token, [&](const Stream& stream) { target = pushTarget(stream); });
  v1::Reply reply;
  *reply.mutable_push_frame() = pushFrame(target, request.intensity);
  *reply.mutable_status() = okStatus();
  answer(std::move(reply));
}

// A thread of its own copies and draws, because pictures may be large. It may also end the feed, which takes
// long: the last holder of a stream does that.
void Service::getFrame(const v1::GetFrame& call, const Answer& answer) {
  Stream stream = streams_.find(call.stream_id(), call.token());
  const v1::View& view = stream.request->view();
  expect(2 * sizeof(float) * view.width() * view.height(), answer);
  pictures_.post([stream = std::move(stream), answer] { answer(pictureReply(stream)); });
}

// As getFrame(), because paths and changes may be many.
void Service::describe(const v1::DescribeStream& call, const Answer& answer) {
  Stream stream = streams_.find(call.stream_id(), call.token());
  expect(descriptionBytes(stream), answer);
  pictures_.post([stream = std::move(stream), answer] { answer(descriptionReply(stream)); });
}

// Counts a large reply before it is made.
void Service::expect(std::size_t bytes, const Answer& answer) {
  constexpr std::size_t kShort = 64 << 10;
  if (bytes > kShort) quota_.use(Limit::kPictures, static_cast<double>(bytes) / kMiB);
  answer.expect(bytes);
}

void Service::fill(const v1::Request& request, const Peer& peer, v1::Reply& reply) {
  const auto control = [&](const auto& call, auto act, auto& answer) {
    streams_.with(call.stream_id(), call.token(), [&](const Stream& stream) { answer = act(stream, call); });
  };
  switch (request.call_case()) {
    case v1::Request::kCloseStream:
      streams_.close(request.close_stream().stream_id(), request.close_stream().token(), peer);
      reply.mutable_close_stream();
      break;
    case v1::Request::kSteer:
      control(request.steer(), steerStream, *reply.mutable_steer());
      break;
    case v1::Request::kChangeSensor:
      control(request.change_sensor(), changeSensor, *reply.mutable_change_sensor());
      break;
    case v1::Request::kListStreams:
      *reply.mutable_list_streams() = listStreams(peer, request.list_streams().all());
      break;
    case v1::Request::kServerInfo:
      *reply.mutable_server_info() = describe_server_();
      break;
    case v1::Request::kCancelOpen:
      if (!opener_.pendingOpens().cancel(peer, request.cancel_open().request_id()))
        throw Refusal(v1::CODE_NOT_FOUND, "request_id", "no stream is being opened by that request");
      reply.mutable_cancel_open();
      break;
    default:
      throw Refusal(v1::CODE_UNIMPLEMENTED, "call", "this server does not know the call");
  }
}

v1::StreamList Service::listStreams(const Peer& peer, bool all) const {
  v1::StreamList list;
  for (auto& info : streams_.list(peer, all)) *list.add_streams() = std::move(info);
  for (auto& info : opener_.pendingOpens().list(peer, all, log_)) *list.add_opening() = std::move(info);
  return list;
}

}  // namespace saccade
