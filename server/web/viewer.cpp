#include "web/viewer.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "saccade/wire/protocol.h"
#include "web/viewer_json.h"

namespace saccade {
namespace {

constexpr std::chrono::milliseconds kTick{100};  // to notice that it is to stop, and that time has passed
constexpr std::chrono::seconds kParting{1};      // for the ends of streams to come
constexpr std::uint16_t kGoingAway = 1001, kInternalError = 1011;  // [RFC 6455]

}  // namespace

Viewer::Viewer(UpgradedSocket socket, zmq::context_t& context, const std::string& control,
               const ViewerStream::Source& source)
    : context_(context),
      source_(source),
      page_(std::move(socket), [this](std::string_view text) { take(text); }),
      control_(client::connectSocket(context, zmq::socket_type::dealer, control, source.keys)),
      control_watch_(context, control_) {}

void Viewer::run(std::stop_token stopped) {
  bool open = true;
  while (open && !stopped.stop_requested() && !connectionLost()) {
    const short replies = page_.full() ? 0 : ZMQ_POLLIN;
    waitForStreams({{nullptr, page_.fd(), page_.events(), 0}, {control_.handle(), 0, replies, 0}});
    for (ViewerStream& stream : streams_) stream.forwardTo(&page_);
    forwardReplies();
    open = page_.exchange();
    if (page_.queuedBytes() == 0) giveBack();
  }
  if (stopped.stop_requested()) return page_.close(kGoingAway, "the server stops");
  if (open) page_.close(kInternalError, "the viewer's connection to the server was lost");
  leave();
}

// With it went the replies that were to come, or what a stream had attached.
bool Viewer::connectionLost() {
  return control_watch_.lost() ||
         std::any_of(streams_.begin(), streams_.end(), [](ViewerStream& stream) { return stream.lost(); });
}

void Viewer::waitForStreams(std::vector<zmq::pollitem_t> others) {
  for (ViewerStream& stream : streams_) others.push_back({stream.handle(), 0, ZMQ_POLLIN, 0});
  zmq::poll(others, kTick);
}

void Viewer::take(std::string_view text) {
  try {
    v1::ViewerMessage message = parseViewerMessage(text);
    if (message.has_request()) return request(std::move(*message.mutable_request()));
    if (!mayJoin())
      return refuse(0, v1::CODE_RESOURCE_EXHAUSTED,
                    "a page joins at most 4 streams at once, and then 10 a second");
    if (message.has_attach()) return join(message.attach());
    join(message.subscribe());
  } catch (const BadViewerMessage& fault) {
    refuse(0, v1::CODE_INVALID_ARGUMENT, fault.what());
  }
}

bool Viewer::mayJoin() {
  const auto now = std::chrono::steady_clock::now();
  if (next_join_ > now + static_cast<int>(kMaxStreams - 1) * kJoinPause) return false;
  next_join_ = std::max(next_join_, now) + kJoinPause;
  return true;
}

template <class Join>
void Viewer::join(const Join& join) {
  std::erase_if(streams_, [](const ViewerStream& stream) { return stream.broadcast(); });
  if (streams_.size() == kMaxStreams) streams_.pop_front();
  streams_.emplace_back(context_, source_, join);
}

// Call it when the page has taken all: a slow one thus loses packets of a LIVE stream.
void Viewer::giveBack() {
  for (ViewerStream& stream : streams_) stream.giveBack();
  std::erase_if(streams_, [](const ViewerStream& stream) { return stream.ended(); });
}

void Viewer::request(v1::Request request) {
  if (in_flight_ >= kMaxInFlight)
    return refuse(request.request_id(), v1::CODE_RESOURCE_EXHAUSTED, "too many requests await a reply");
  if (request.has_close_stream()) {
    const v1::CloseStream& close = request.close_stream();
    if (close.token().empty())  // which all pages, as one client, could leave out
      return refuse(request.request_id(), v1::CODE_PERMISSION_DENIED, "a page closes a stream by its token");
    opened_.erase(close.stream_id());
  }
  if (control_.send(zmq::buffer(request.SerializeAsString()), zmq::send_flags::dontwait)) ++in_flight_;
}

void Viewer::refuse(std::uint64_t request_id, v1::Code code, const std::string& message) {
  v1::Reply reply;
  reply.set_request_id(request_id);
  reply.mutable_status()->set_code(code);
  reply.mutable_status()->set_message(message);
  page_.sendText(toJson(reply));
}

void Viewer::forwardReplies() {
  zmq::message_t bytes;
  while (!page_.full() && control_.recv(bytes, zmq::recv_flags::dontwait)) {
    --in_flight_;
    v1::Reply reply;
    if (!reply.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) continue;
    note(reply);
    page_.sendText(toJson(reply));
  }
}

void Viewer::note(const v1::Reply& reply) {
  if (reply.has_open_stream()) opened_[reply.open_stream().stream_id()] = reply.open_stream().token();
}

// Takes what is left of the streams: the server keeps one until its END is taken, or for its lease.
void Viewer::leave() {
  control_.set(zmq::sockopt::linger, static_cast<int>(kTick.count()));
  std::erase_if(streams_, [](const ViewerStream& stream) { return stream.broadcast(); });
  for (const auto& [stream_id, token] : opened_) {
    v1::Request request;
    request.set_protocol_version(kProtocolVersion);
    request.mutable_close_stream()->set_stream_id(stream_id);
    request.mutable_close_stream()->set_token(token);
    control_.send(zmq::buffer(request.SerializeAsString()), zmq::send_flags::dontwait);
  }
  const auto until = std::chrono::steady_clock::now() + kParting;
  while (!streams_.empty() && std::chrono::steady_clock::now() < until) {
    waitForStreams({});
    for (ViewerStream& stream : streams_) stream.forwardTo(nullptr);
    giveBack();
  }
}

}  // namespace saccade
