#include "stream/data_server.h"

#include <algorithm>

namespace saccade {
namespace {

constexpr std::chrono::milliseconds kFullPause{2};  // until a peer whose queue is full is tried again

}  // namespace

DataServer::DataServer(const std::string& endpoint, const SessionDirectory& sessions, std::int64_t max_credit,
                       const std::optional<ServerKeys>& keys)
    : loop_({.endpoint = endpoint, .keys = keys}), sessions_(sessions), max_credit_(max_credit) {}

void DataServer::start() {
  loop_.start([this](const SocketLoop::Message& message) { receive(message); },
              [this] { return sendPackets(); });
}

void DataServer::receive(const SocketLoop::Message& message) {
  const std::vector<std::string>& parts = message.parts;
  v1::DataRequest request;
  if (!hasServersName(parts[0])) return refuse(parts[0], {}, kNamedItself);
  const bool parsed = parts.size() == 2 && request.ParseFromString(parts[1]);
  const std::string fault =
      parsed ? handle(message, request) : "a request is one part: a serialized saccade.v1.DataRequest";
  if (!parsed) request.Clear();  // what was read before the fault may hold a text that is no UTF-8
  if (!fault.empty()) refuse(parts[0], request.attach().stream_id(), fault);
}

std::string DataServer::handle(const SocketLoop::Message& message, const v1::DataRequest& request) {
  const std::string& identity = message.parts[0];
  switch (request.request_case()) {
    case v1::DataRequest::kAttach:
      return attach(message, request.attach());
    case v1::DataRequest::kCredit:
      return addCredit(identity, request.credit().bytes());
    case v1::DataRequest::kAck:
      return acknowledge(identity, request.ack());
    default:
      return "the request holds nothing that this server knows";
  }
}

std::string DataServer::attach(const SocketLoop::Message& message, const v1::Attach& request) {
  const std::string& identity = message.parts[0];
  const auto session = sessions_.find(request.stream_id());
  // One message for both, so that nobody learns which streams exist.
  if (!session || session->broadcast() || !session->hasToken(request.token())) {
    return "no stream of this name on the data socket has this token";
  }
  std::vector<std::uint64_t> from(session->sensors(), request.from_seq());
  if (request.from_seqs_size() > 0) from.assign(request.from_seqs().begin(), request.from_seqs().end());
  if (from.size() != session->sensors()) {
    return "from_seqs has one seq for each of the " + std::to_string(session->sensors()) + " sensors";
  }
  if (std::string fault = session->queue().resume(from); !fault.empty()) return fault;
  takeOver(*session, identity);
  Connection& connection = connections_[identity];
  if (connection.session && connection.session != session) connection.session->leave();
  connection.session = session;
  connection.user = message.user;
  session->start();
  return {};
}

// Only who knows the token comes here: most likely the same client, on a new connection.
void DataServer::takeOver(const Session& session, const std::string& identity) {
  const auto former = std::find_if(connections_.begin(), connections_.end(), [&](const auto& entry) {
    return entry.second.session.get() == &session && entry.first != identity;
  });
  if (former == connections_.end()) return;
  refuse(former->first, session.id(), "another connection has attached to the stream");
  connections_.erase(former);
}

std::string DataServer::addCredit(const std::string& identity, std::uint64_t bytes) {
  const auto found = connections_.find(identity);
  if (found == connections_.end()) return "attach to a stream before giving credit";
  std::int64_t& credit = found->second.credit_bytes;
  if (bytes > static_cast<std::uint64_t>(max_credit_ - std::max<std::int64_t>(0, credit))) {
    return "limit credit: a connection has at most " + std::to_string(max_credit_) + " bytes";
  }
  credit += static_cast<std::int64_t>(bytes);
  return {};
}

std::string DataServer::acknowledge(const std::string& identity, const v1::Ack& ack) {
  const auto found = connections_.find(identity);
  if (found == connections_.end()) return "attach to a stream before acknowledging packets";
  Session& session = *found->second.session;
  if (ack.sensor() >= session.sensors()) return "the stream has no sensor " + std::to_string(ack.sensor());
  session.queue().acknowledge(ack.sensor(), ack.seq());
  return {};
}

void DataServer::refuse(const std::string& identity, const std::string& stream_id,
                        const std::string& message) {
  const Packet packet = makeErrorPacket(stream_id, message);
  loop_.send({identity, packet.header.SerializeAsString(), *packet.payload});
}

std::chrono::milliseconds DataServer::sendPackets() {
  auto pause = connections_.empty() ? SocketLoop::kUntilWoken : kHeartbeatPause;
  for (auto it = connections_.begin(); it != connections_.end();) {
    const bool revoked = !loop_.allows(it->second.user);
    const auto sent = revoked ? SocketLoop::Sent::kGone : sendPacketsOf(it->first, it->second);
    if (sent == SocketLoop::Sent::kFull) pause = kFullPause;
    const bool gone = sent == SocketLoop::Sent::kGone;
    if (gone) it->second.session->leave();
    it = gone || !sessions_.find(it->second.session->id()) ? connections_.erase(it) : std::next(it);
  }
  return pause;
}

SocketLoop::Sent DataServer::sendPacketsOf(const std::string& identity, Connection& connection) {
  auto sent = SocketLoop::Sent::kYes;
  const auto send = [&](const WirePacket& packet) {
    sent = loop_.send({identity, packet.header, *packet.payload});
    if (sent != SocketLoop::Sent::kYes) return false;
    connection.credit_bytes -= static_cast<std::int64_t>(packet.bytes());
    connection.last_sent = Signal::Clock::now();
    return true;
  };
  // The last packet may overdraw the credit: less than a packet's worth shall not stall a stream in silence.
  while (connection.credit_bytes > 0 && connection.session->sendOldest(send)) {
  }
  if (sent != SocketLoop::Sent::kYes) return sent;
  const bool quiet = Signal::Clock::now() - connection.last_sent >= kHeartbeatPause;
  return quiet ? sendHeartbeat(identity, connection) : SocketLoop::Sent::kYes;
}

SocketLoop::Sent DataServer::sendHeartbeat(const std::string& identity, Connection& connection) {
  const Packet packet = connection.session->heartbeat();
  connection.last_sent = Signal::Clock::now();
  return loop_.send({identity, packet.header.SerializeAsString(), *packet.payload});
}

}  // namespace saccade
