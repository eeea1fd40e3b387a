#include "stream/control_server.h"

#include <limits>
#include <mutex>
#include <new>

#include "stream/endpoint.h"

namespace saccade {
v1::Status readRequest(std::vector<MessagePart>&& parts, RawRequest& request) {
  if (parts.size() != 1) return makeStatus(v1::CODE_INVALID_ARGUMENT, kNoRequest);
  request.message = std::move(parts[0]);
  return readHead(request);
}

// Replies on their way from the threads that answer to the one that sends.
struct ControlServer::Outbox {
  struct Letter {
    std::string connection, bytes;
    std::shared_ptr<UnreadReply> unread;
  };
  std::mutex mutex;
  std::vector<std::shared_ptr<Letter>> letters;

  // Returns the code of the reply that it puts in. Without memory for `reply` it puts in a shorter one.
  // Keeps no hold on `unread` once the reply can be sent: a thread of low priority may return much later.
  v1::Code put(const std::string& connection, v1::Reply reply, std::shared_ptr<UnreadReply> unread) {
    std::string bytes;
    try {
      bytes = reply.SerializeAsString();
    } catch (const std::bad_alloc&) {
      *reply.mutable_status() = noMemoryStatus();
      reply.clear_result();
      bytes = reply.SerializeAsString();
    }
    auto letter = std::make_shared<Letter>(Letter{connection, std::move(bytes), std::move(unread)});
    letter->unread->make(letter->bytes.size());
    std::lock_guard lock(mutex);
    letters.push_back(std::move(letter));
    return reply.status().code();
  }
};

ControlServer::ControlServer(const Options& options, RequestCounts& counts)
    : unread_bytes_(options.unread_bytes),
      clients_(options.access.keys ? options.access.keys->clients : nullptr),
      counts_(counts),
      loop_(std::make_shared<SocketLoop>(
          SocketOptions{.endpoint = options.endpoint,
                        .max_part_bytes = options.request_bytes,
                        .send_queue = 2 * kMaxUnread,  // the other half for refusals
                        .send_queue_bytes = std::numeric_limits<std::size_t>::max(),  // see unread_bytes
                        .access = options.access})),
      outbox_(std::make_shared<Outbox>()) {}

ControlServer::~ControlServer() {
  stop();
}

void ControlServer::start(Handler handler, OnGone on_gone) {
  handler_ = std::move(handler);
  loop_->start([this](SocketLoop::Message&& message) { receive(std::move(message)); },
               [this] {
                 sendReplies();
                 return SocketLoop::kUntilWoken;
               },
               std::move(on_gone));
}

void ControlServer::stop() {
  loop_->stop();
}

void ControlServer::receive(SocketLoop::Message&& message) {
  const std::string& connection = message.peer;
  auto& unread = unread_[connection];
  if (!unread) unread.reset(new Unread{message.user});
  RawRequest request;
  v1::Status status = readRequest(std::move(message.parts), request);
  if (status.code() == v1::CODE_OK) status = admit(*unread, request.call);
  if (message.revoked) status = makeStatus(v1::CODE_PERMISSION_DENIED, kRevokedKey);
  Answer answer = answerTo(connection, request, unread);
  if (status.code() == v1::CODE_OK) return handler_(std::move(request), peerOf(message), std::move(answer));
  v1::Reply refusal;
  *refusal.mutable_status() = std::move(status);
  answer(std::move(refusal));
}

Peer ControlServer::peerOf(const SocketLoop::Message& message) const {
  const bool admin = clients_ ? clients_->find(message.user).admin : isLoopback(loop_->endpoint());
  return {message.peer, message.user, admin};
}

bool ControlServer::othersLeaveRoom(const Unread& unread) const {
  std::int64_t all = 0, client = 0;
  for (const auto& [connection, one] : unread_) {
    all += one->bytes;
    if (!one->user.empty() && one->user == unread.user) client += one->bytes;
  }
  const std::int64_t most = kUnreadShares * unread_bytes_;
  return all <= most && client <= most / 2;
}

v1::Status ControlServer::admit(const Unread& unread, v1::Request::CallCase call) const {
  const bool large = call == v1::Request::kOpenStream || call == v1::Request::kGetFrame ||
                     call == v1::Request::kDescribeStream;
  const bool own_room = unread.replies < kMaxUnread && unread.bytes <= unread_bytes_;
  if (own_room && ((!large && unread.bytes == 0) || othersLeaveRoom(unread))) return okStatus();
  v1::Status status = makeStatus(v1::CODE_RESOURCE_EXHAUSTED,
                                 "limit replies: read the replies that wait on this connection first");
  status.set_limit("replies");
  return status;
}

Answer ControlServer::answerTo(const std::string& connection, const RawRequest& request,
                               std::shared_ptr<Unread> peer) {
  const auto client = clients_ ? clients_->countsOf(peer->user) : nullptr;
  auto unread = std::make_shared<UnreadReply>(std::move(peer), request.message.bytes.size(), counts_);
  const auto expect = [weak = std::weak_ptr(unread)](std::size_t bytes) {
    if (const auto reply = weak.lock()) reply->expect(bytes);
  };
  // Copies of `give` share one hold: those that are kept must not keep the reply counted.
  const auto hold = std::make_shared<std::shared_ptr<UnreadReply>>(std::move(unread));
  const auto give = [outbox = outbox_, loop = loop_, connection, hold, id = request.id, call = request.call,
                     &counts = counts_, client](v1::Reply reply) {
    reply.set_request_id(id);
    const v1::Code code = outbox->put(connection, std::move(reply), std::move(*hold));
    counts.add({call, code});
    if (client && code != v1::CODE_OK) ++client->refusals;
    loop->wake().wake();
  };
  return {give, expect};
}

void ControlServer::sendReplies() {
  std::vector<std::shared_ptr<Outbox::Letter>> letters;
  {
    std::lock_guard lock(outbox_->mutex);
    letters.swap(outbox_->letters);
  }
  for (const auto& letter : letters) {
    const std::shared_ptr<const std::string> bytes(letter, &letter->bytes);
    if (loop_->send(letter->connection, {bytes}) == SocketLoop::Sent::kFull) counts_.drop();
  }
  std::erase_if(unread_, [](const auto& entry) { return entry.second->replies == 0; });
}

}  // namespace saccade
