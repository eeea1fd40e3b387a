#include "stream/broadcast_server.h"

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

// A subscription is one part: 1 (or 0 to end it), then the topic.
void BroadcastServer::receive(const std::vector<std::string>& parts) {
  if (parts.size() != 1 || parts[0].empty() || static_cast<unsigned char>(parts[0][0]) > 1) return;
  const bool wanted = parts[0][0] == 1;
  const std::string topic = parts[0].substr(1);
  if (!wanted) return loop_.setSubscription(topic, false);
  const auto session = findByTopic(sessions_, topic);
  if (!session) return;
  loop_.setSubscription(topic, true);
  if (session->started()) return;
  const auto [joining, first] = joining_.try_emplace(session->id());
  if (first) joining->second.deadline = Signal::Clock::now() + kJoinTime;
  joining->second.topics.insert(topic);
}

std::chrono::milliseconds BroadcastServer::turn() {
  std::erase_if(joining_, [&](const auto& entry) { return !sessions_.find(entry.first); });
  for (const auto& session : sessions_.all()) {
    if (!session->broadcast()) continue;
    if (ready(*session)) {
      joining_.erase(session->id());
      session->start();
    }
    sendPacketsOf(*session);
  }
  return joining_.empty() ? SocketLoop::kUntilWoken : kJoinTime;
}

bool BroadcastServer::ready(const Session& session) const {
  const auto found = joining_.find(session.id());
  return found != joining_.end() &&
         (found->second.topics.size() == session.sensors() || Signal::Clock::now() >= found->second.deadline);
}

void BroadcastServer::sendPacketsOf(Session& session) {
  while (session.sendOldest([&](const WirePacket& packet) {
    loop_.send({session.topic(packet.sensor), packet.header, *packet.payload});
    return true;  // who is too slow for it has lost it
  })) {
  }
}

}  // namespace saccade
