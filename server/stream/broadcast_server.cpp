#include "stream/broadcast_server.h"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

namespace saccade {
namespace {

std::shared_ptr<Session> findByTopic(const SessionDirectory& sessions, const std::string& topic) {
  if (!topic.starts_with(kTopicPrefix)) return nullptr;
  const auto begin = kTopicPrefix.size(), end = topic.find('/', begin);
  const auto session = sessions.find(topic.substr(begin, end - begin));
  if (!session || !session->broadcast()) return nullptr;
  for (std::uint32_t i = 0; i < session->channels(); ++i) {
    if (session->topic(i) == topic) return session;
  }
  return nullptr;
}

struct Subscription {
  bool wanted;
  std::string topic;
};

// A subscription is one part: 1 (or 0 to end it) and the topic [ZMTP 3.0], or a command of that name
// [ZMTP 3.1].
std::optional<Subscription> readSubscription(const std::vector<MessagePart>& parts) {
  using namespace std::string_view_literals;
  if (parts.size() != 1) return {};
  constexpr std::pair<std::string_view, bool> kForms[] = {
      {"\1"sv, true}, {"\0"sv, false}, {"\x09SUBSCRIBE"sv, true}, {"\6CANCEL"sv, false}};
  const std::string_view bytes = parts[0].bytes;
  for (const auto& [begin, wanted] : kForms) {
    if (bytes.starts_with(begin)) return Subscription{wanted, std::string(bytes.substr(begin.size()))};
  }
  return {};
}

}  // namespace

// Topics are short. A slow subscriber loses packets at its own queue; a gap of seq shows it.
BroadcastServer::BroadcastServer(const std::string& endpoint, const SessionDirectory& sessions,
                                 const Access& access)
    : loop_({.endpoint = endpoint,
             .for_subscribers = true,
             .max_part_bytes = 512,  // the largest message of the handshake of CURVE has about 300
             .send_queue = 256,
             .send_queue_bytes = 4 << 20,
             .access = access}),
      sessions_(sessions) {}

void BroadcastServer::start() {
  loop_.start([this](SocketLoop::Message&& message) { receive(message); }, [this] { return turn(); },
              [this](const std::string& peer) { forget(peer); });
}

void BroadcastServer::receive(const SocketLoop::Message& message) {
  const auto asked = readSubscription(message.parts);
  if (!asked || message.revoked) return;
  if (asked->wanted) {
    subscribe(message, asked->topic);
  } else {
    unsubscribe(message.peer, asked->topic);
  }
}

void BroadcastServer::subscribe(const SocketLoop::Message& message, const std::string& topic) {
  const auto session = findByTopic(sessions_, topic);
  if (!session) return;
  Subscriber& subscriber = subscribers_[message.peer];
  subscriber.user = message.user;
  if (subscriber.topics.size() >= kMaxTopics || !subscriber.topics.insert(topic).second) return;
  Audience& audience = audiences_[session->id()];
  if (audience.peers.empty()) audience.first = ChangeNotifier::Clock::now();
  audience.peers[topic].insert(message.peer);
}

void BroadcastServer::unsubscribe(const std::string& peer, const std::string& topic) {
  const auto subscriber = subscribers_.find(peer);
  if (subscriber == subscribers_.end() || subscriber->second.topics.erase(topic) == 0) return;
  const auto session = findByTopic(sessions_, topic);
  if (!session) return;  // it is over, and its audience about to go
  Audience& audience = audiences_[session->id()];
  const auto found = audience.peers.find(topic);
  if (found == audience.peers.end()) return;
  found->second.erase(peer);
  if (found->second.empty()) audience.peers.erase(found);
  if (!audience.peers.empty()) return;
  audience.announced = false;
  session->leave();
}

void BroadcastServer::forget(const std::string& peer) {
  const auto found = subscribers_.find(peer);
  if (found == subscribers_.end()) return;
  const auto topics = found->second.topics;
  for (const std::string& topic : topics) unsubscribe(peer, topic);
  subscribers_.erase(peer);
}

std::chrono::milliseconds BroadcastServer::turn() {
  forgetRevoked();
  for (auto it = audiences_.begin(); it != audiences_.end();) {
    const auto session = sessions_.find(it->first);
    if (session) serve(*session, it->second);
    it = session ? std::next(it) : audiences_.erase(it);
  }
  for (const std::string& peer : std::exchange(gone_, {})) forget(peer);
  const bool waiting = std::any_of(audiences_.begin(), audiences_.end(), [](const auto& entry) {
    return !entry.second.announced && !entry.second.peers.empty();
  });
  return waiting ? kJoinTime : audiences_.empty() ? SocketLoop::kUntilWoken : kHeartbeatPause;
}

void BroadcastServer::forgetRevoked() {
  std::set<std::string> revoked;
  for (const auto& [peer, subscriber] : subscribers_) {
    if (!loop_.allows(subscriber.user)) revoked.insert(peer);
  }
  for (const std::string& peer : revoked) forget(peer);
}

void BroadcastServer::serve(Session& session, Audience& audience) {
  if (!audience.announced && complete(session, audience)) {
    audience.announced = true;
    audience.last_sent = ChangeNotifier::Clock::now();
    session.start();
  }
  sendPacketsOf(session, audience);
}

bool BroadcastServer::complete(const Session& session, const Audience& audience) const {
  if (audience.peers.empty()) return false;
  return audience.peers.size() == session.channels() ||
         ChangeNotifier::Clock::now() - audience.first >= kJoinTime;
}

void BroadcastServer::sendPacketsOf(Session& session, Audience& audience) {
  const auto now = ChangeNotifier::Clock::now();
  while (session.sendOldest([&](const WirePacket& packet) {
    const auto payload = session.lend(packet);
    if (payload) sendTo(audience, session.topic(packet.sensor), packet.header, payload);
    return true;  // who is too slow for it has lost it, and all have where the slow ones hold too much
  })) {
    audience.last_sent = now;
  }
  if (!audience.announced || now - audience.last_sent < kHeartbeatPause) return;
  for (std::uint32_t i = 0; i < session.channels(); ++i) {
    sendTo(audience, session.topic(i), session.heartbeat(i).header.SerializeAsString(), std::string_view());
  }
  audience.last_sent = now;
}

void BroadcastServer::sendTo(const Audience& audience, const std::string& topic, const MessagePart& header,
                             const MessagePart& payload) {
  const auto peers = audience.peers.find(topic);
  if (peers == audience.peers.end()) return;
  for (const std::string& peer : peers->second) {
    const auto sent = loop_.send(peer, {topic, header, payload});
    if (sent == SocketLoop::Sent::kGone) gone_.insert(peer);
  }
}

}  // namespace saccade
