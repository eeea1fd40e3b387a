#include "stream/broadcast_server.h"

#include <algorithm>
#include <iterator>

namespace saccade {
namespace {

std::shared_ptr<Session> findByTopic(const SessionDirectory& sessions, const std::string& topic) {
  for (const auto& session : sessions.all()) {
    if (!session->broadcast()) continue;
    for (std::uint32_t i = 0; i < session->sensors(); ++i) {
      if (session->topic(i) == topic) return session;
    }
  }
  return nullptr;
}

}  // namespace

// Topics are short. What a subscriber is too slow for is dropped at its own queue; a gap of seq shows it.
BroadcastServer::BroadcastServer(const std::string& endpoint, const SessionDirectory& sessions,
                                 const std::optional<ServerKeys>& keys)
    : loop_({.kind = SocketOptions::Kind::kXPub,
             .endpoint = endpoint,
             .max_part_bytes = 512,  // the largest message of the handshake of CURVE has about 300
             .send_queue = 256,
             .keys = keys}),
      sessions_(sessions) {}

void BroadcastServer::start() {
  loop_.start([this](const SocketLoop::Message& message) { receive(message.parts); },
              [this] { return turn(); });
}

// A subscription is one part: 1 (or 0 to end it), then the topic. The end of a connection ends all of its
// own.
void BroadcastServer::receive(const std::vector<std::string>& parts) {
  if (parts.size() != 1 || parts[0].empty() || static_cast<unsigned char>(parts[0][0]) > 1) return;
  const bool wanted = parts[0][0] == 1;
  const std::string topic = parts[0].substr(1);
  const auto session = findByTopic(sessions_, topic);
  if (!session) return;
  loop_.setSubscription(topic, wanted);
  if (!wanted) return unsubscribe(*session, topic);
  Audience& audience = audiences_[session->id()];
  if (audience.subscribers.empty()) audience.first = Signal::Clock::now();
  ++audience.subscribers[topic];
}

void BroadcastServer::unsubscribe(Session& session, const std::string& topic) {
  Audience& audience = audiences_[session.id()];
  const auto found = audience.subscribers.find(topic);
  if (found != audience.subscribers.end() && --found->second == 0) audience.subscribers.erase(found);
  if (!audience.subscribers.empty()) return;
  audience.told = false;
  session.leave();
}

std::chrono::milliseconds BroadcastServer::turn() {
  for (auto it = audiences_.begin(); it != audiences_.end();) {
    const auto session = sessions_.find(it->first);
    if (session) serve(*session, it->second);
    it = session ? std::next(it) : audiences_.erase(it);
  }
  const bool waiting = std::any_of(audiences_.begin(), audiences_.end(), [](const auto& entry) {
    return !entry.second.told && !entry.second.subscribers.empty();
  });
  return waiting ? kJoinTime : audiences_.empty() ? SocketLoop::kUntilWoken : kHeartbeatPause;
}

void BroadcastServer::serve(Session& session, Audience& audience) {
  if (!audience.told && complete(session, audience)) {
    audience.told = true;
    audience.last_sent = Signal::Clock::now();
    session.start();
  }
  sendPacketsOf(session, audience);
}

bool BroadcastServer::complete(const Session& session, const Audience& audience) const {
  if (audience.subscribers.empty()) return false;
  return audience.subscribers.size() == session.sensors() ||
         Signal::Clock::now() - audience.first >= kJoinTime;
}

void BroadcastServer::sendPacketsOf(Session& session, Audience& audience) {
  const auto now = Signal::Clock::now();
  while (session.sendOldest([&](const WirePacket& packet) {
    loop_.send({session.topic(packet.sensor), packet.header, *packet.payload});
    return true;  // who is too slow for it has lost it
  })) {
    audience.last_sent = now;
  }
  if (!audience.told || now - audience.last_sent < kHeartbeatPause) return;
  for (std::uint32_t i = 0; i < session.sensors(); ++i) {
    loop_.send({session.topic(i), session.heartbeat(i).header.SerializeAsString(), {}});
  }
  audience.last_sent = now;
}

}  // namespace saccade
