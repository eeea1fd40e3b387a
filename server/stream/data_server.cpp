#include "stream/data_server.h"

#include <algorithm>
#include <iterator>

#include "base/text_cut.h"

namespace saccade {
namespace {

constexpr std::chrono::milliseconds kFullPause{2};  // until a peer whose queue is full is tried again
constexpr std::uint64_t kBytesPerTurn = 1 << 20;    // of a connection; then the others have theirs

bool parse(std::string_view bytes, v1::DataRequest& request) {
  return request.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()));
}

}  // namespace

DataServer::DataServer(const std::string& endpoint, const SessionDirectory& sessions, std::int64_t max_credit,
                       const Access& access)
    : loop_({.endpoint = endpoint, .send_queue_bytes = kBytesPerTurn, .access = access}),
      sessions_(sessions),
      max_credit_(max_credit) {}

void DataServer::start() {
  loop_.start([this](SocketLoop::Message&& message) { receive(message); }, [this] { return sendPackets(); },
              [this](const std::string& peer) { forget(peer); });
}

void DataServer::receive(const SocketLoop::Message& message) {
  if (message.revoked && find(message)) return;  // sendPackets() tells it, with the name of the stream
  if (message.revoked) return refuse(message.peer, {}, kRevokedKey);
  v1::DataRequest request;
  const bool parsed = message.parts.size() == 1 && parse(message.parts[0].bytes, request);
  const std::string fault =
      parsed ? handle(message, request) : "a request is one part: a serialized saccade.v1.DataRequest";
  if (!parsed) request.Clear();  // a half-parsed request may hold a text that is not UTF-8
  if (!fault.empty()) refuse(message.peer, cutText(request.attach().stream_id(), kMaxEcho), fault);
}

std::string DataServer::handle(const SocketLoop::Message& message, const v1::DataRequest& request) {
  if (request.has_attach()) return attach(message, request.attach());
  if (request.request_case() == v1::DataRequest::REQUEST_NOT_SET) {
    return "the request holds nothing that this server knows";
  }
  Connection* connection = find(message);
  if (!connection) return "attach to a stream before giving credit or acknowledging packets";
  return request.has_credit() ? addCredit(*connection, request.credit().bytes())
                              : acknowledge(*connection, request.ack());
}

// A connection is its peer's only with the same key.
DataServer::Connection* DataServer::find(const SocketLoop::Message& message) {
  const auto found = connections_.find(message.peer);
  return found == connections_.end() || found->second.user != message.user ? nullptr : &found->second;
}

void DataServer::forget(const std::string& peer) {
  const auto found = connections_.find(peer);
  if (found == connections_.end()) return;
  found->second.session->leave();
  connections_.erase(found);
}

std::string DataServer::attach(const SocketLoop::Message& message, const v1::Attach& request) {
  const auto session = sessions_.find(request.stream_id());
  // One message for both, so that nobody learns which streams exist.
  if (!session || session->broadcast() || !session->hasToken(request.token())) {
    return "no stream of this name on the data socket has this token";
  }
  std::vector<std::uint64_t> from(session->channels(), request.from_seq());
  if (request.from_seqs_size() > 0) from.assign(request.from_seqs().begin(), request.from_seqs().end());
  if (from.size() != session->channels()) {
    return "from_seqs has one seq for each of the " + std::to_string(session->channels()) +
           " sensors and truth channels";
  }
  if (std::string fault = session->resume(from); !fault.empty()) return fault;
  takeOver(*session, message.peer);
  Connection& connection = connections_[message.peer];
  if (connection.session && connection.session != session) connection.session->leave();
  connection.session = session;
  connection.user = message.user;
  session->start();
  return {};
}

// The peer knows the token: most likely it is the same client, on a new connection.
void DataServer::takeOver(const Session& session, const std::string& peer) {
  const auto former = std::find_if(connections_.begin(), connections_.end(), [&](const auto& entry) {
    return entry.second.session.get() == &session && entry.first != peer;
  });
  if (former == connections_.end()) return;
  refuse(former->first, session.id(), "another connection has attached to the stream");
  connections_.erase(former);
}

std::string DataServer::addCredit(Connection& connection, std::uint64_t bytes) {
  std::int64_t& credit = connection.credit_bytes;
  if (bytes > static_cast<std::uint64_t>(max_credit_ - std::max<std::int64_t>(0, credit))) {
    return "limit credit: a connection has at most " + std::to_string(max_credit_) + " bytes";
  }
  credit += static_cast<std::int64_t>(bytes);
  return {};
}

std::string DataServer::acknowledge(Connection& connection, const v1::Ack& ack) {
  Session& session = *connection.session;
  if (ack.sensor() >= session.channels()) return "the stream has no sensor " + std::to_string(ack.sensor());
  session.acknowledge(ack.sensor(), ack.seq());
  return {};
}

void DataServer::refuse(const std::string& peer, const std::string& stream_id, const std::string& message) {
  const Packet packet = makeErrorPacket(stream_id, message, sessions_.epoch());
  loop_.send(peer, {packet.header.SerializeAsString(), *packet.payload});
}

std::chrono::milliseconds DataServer::sendPackets() {
  auto pause = connections_.empty() ? SocketLoop::kUntilWoken : kHeartbeatPause;
  for (auto it = connections_.begin(); it != connections_.end();) {
    const bool revoked = !loop_.allows(it->second.user);
    if (revoked) refuse(it->first, it->second.session->id(), kRevokedKey);
    const auto sent = revoked ? SocketLoop::Sent::kGone : sendPacketsOf(it->first, it->second);
    if (sent == SocketLoop::Sent::kFull) pause = kFullPause;
    const bool gone = sent == SocketLoop::Sent::kGone;
    if (gone) it->second.session->leave();
    it = gone || !sessions_.find(it->second.session->id()) ? connections_.erase(it) : std::next(it);
  }
  return pause;
}

// Returns kFull also at the end of the connection's turn, and where former connections hold too much.
SocketLoop::Sent DataServer::sendPacketsOf(const std::string& peer, Connection& connection) {
  auto sent = SocketLoop::Sent::kYes;
  std::uint64_t bytes = 0;
  const auto send = [&](const WirePacket& packet) {
    const auto payload = bytes < kBytesPerTurn ? connection.session->lend(packet) : nullptr;
    sent = payload ? loop_.send(peer, {packet.header, payload}) : SocketLoop::Sent::kFull;
    if (sent != SocketLoop::Sent::kYes) return false;
    bytes += packet.bytes();
    connection.credit_bytes -= static_cast<std::int64_t>(packet.bytes());
    connection.last_sent = ChangeNotifier::Clock::now();
    return true;
  };
  // The last packet may overdraw the credit: a rest of less than a packet must not stall the stream.
  while (connection.credit_bytes > 0 && connection.session->sendOldest(send)) {
  }
  if (sent != SocketLoop::Sent::kYes) return sent;
  const bool quiet = ChangeNotifier::Clock::now() - connection.last_sent >= kHeartbeatPause;
  return quiet ? sendHeartbeat(peer, connection) : SocketLoop::Sent::kYes;
}

SocketLoop::Sent DataServer::sendHeartbeat(const std::string& peer, Connection& connection) {
  const Packet packet = connection.session->heartbeat();
  connection.last_sent = ChangeNotifier::Clock::now();
  return loop_.send(peer, {packet.header.SerializeAsString(), *packet.payload});
}

}  // namespace saccade
