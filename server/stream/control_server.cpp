#include "stream/control_server.h"

#include "base/text_cut.h"
#include "wire/protocol.h"

namespace saccade {
namespace {

constexpr std::size_t kMaxStatusBytes = 4096;  // scene files and their names may hold any bytes

}  // namespace

v1::Status okStatus() {
  return makeStatus(v1::CODE_OK, {});
}

v1::Status makeStatus(v1::Code code, const std::string& message, const std::string& field) {
  v1::Status status;
  status.set_code(code);
  status.set_message(cutText(message, kMaxStatusBytes));
  status.set_field(field);
  return status;
}

v1::Status readRequest(const std::vector<std::string>& parts, v1::Request& request) {
  if (!hasServersName(parts[0])) return makeStatus(v1::CODE_INVALID_ARGUMENT, kNamedItself);
  if (parts.size() != 2 || !request.ParseFromString(parts[1])) {
    return makeStatus(v1::CODE_INVALID_ARGUMENT, "a request is one part: a serialized saccade.v1.Request");
  }
  if (request.protocol_version() != kProtocolVersion) {
    return makeStatus(v1::CODE_UNIMPLEMENTED,
                      "protocol_version is " + std::to_string(request.protocol_version()) +
                          "; this server knows " + std::to_string(kProtocolVersion),
                      "protocol_version");
  }
  if (request.call_case() == v1::Request::CALL_NOT_SET) {
    return makeStatus(v1::CODE_UNIMPLEMENTED, "the request holds no call that this server knows", "call");
  }
  return okStatus();
}

// Replies on their way from the threads that answer to the one that sends.
struct ControlServer::Outbox {
  std::mutex mutex;
  std::vector<std::pair<std::string, std::string>> replies;  // identity, bytes

  void put(const std::string& identity, const v1::Reply& reply) {
    std::lock_guard lock(mutex);
    replies.emplace_back(identity, reply.SerializeAsString());
  }
};

ControlServer::ControlServer(const std::string& endpoint, std::int64_t max_bytes, RequestCounts& counts,
                             const std::optional<ServerKeys>& keys)
    : counts_(counts),
      loop_(std::make_shared<SocketLoop>(
          SocketOptions{.endpoint = endpoint,
                        .max_part_bytes = max_bytes,
                        .send_queue = 1024,  // replies, mostly short, to who asks much at once
                        .keys = keys})),
      outbox_(std::make_shared<Outbox>()) {}

ControlServer::~ControlServer() {
  stop();
}

void ControlServer::start(Handler handler) {
  handler_ = std::move(handler);
  loop_->start([this](const SocketLoop::Message& message) { receive(message); },
               [this] {
                 sendReplies();
                 return SocketLoop::kUntilWoken;
               });
}

void ControlServer::stop() {
  loop_->stop();
}

void ControlServer::receive(const SocketLoop::Message& message) {
  v1::Request request;
  v1::Status status = readRequest(message.parts, request);
  Answer answer = [outbox = outbox_, loop = loop_, identity = message.parts[0], id = request.request_id(),
                   call = request.call_case(), &counts = counts_](v1::Reply reply) {
    counts.add({call, reply.status().code()});
    reply.set_request_id(id);
    outbox->put(identity, reply);
    loop->wake().wake();
  };
  if (status.code() == v1::CODE_OK) return handler_(request, message.user, std::move(answer));
  v1::Reply refusal;
  *refusal.mutable_status() = std::move(status);
  answer(std::move(refusal));
}

void ControlServer::sendReplies() {
  std::vector<std::pair<std::string, std::string>> replies;
  {
    std::lock_guard lock(outbox_->mutex);
    replies.swap(outbox_->replies);
  }
  // One that is not sent had a receiver who is gone, or who asks without ever reading.
  for (const auto& [identity, bytes] : replies) loop_->send({identity, bytes});
}

}  // namespace saccade
