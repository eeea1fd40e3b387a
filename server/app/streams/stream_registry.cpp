#include "app/streams/stream_registry.h"

#include <algorithm>

#include "app/request/enum_names.h"
#include "app/request/refusal.h"
#include "base/text_cut.h"

namespace saccade {
namespace {

// These throw Refusal.
template <class Streams>
auto& streamOf(Streams& streams, const std::string& id) {
  const auto found = streams.find(id);
  if (found == streams.end()) {
    throw Refusal(v1::CODE_NOT_FOUND, "stream_id", "there is no stream '" + cutText(id, kMaxEcho) + "'");
  }
  return found->second;
}

template <class Streams>
auto& streamOf(Streams& streams, const std::string& id, const std::string& token) {
  auto& stream = streamOf(streams, id);
  if (!stream.session->hasToken(token)) {
    throw Refusal(v1::CODE_PERMISSION_DENIED, "token", "this is not the stream's token");
  }
  return stream;
}

void requireOwner(const Stream& stream, const Peer& peer) {
  const bool own = !peer.user.empty() && peer.user == stream.user;
  if (own || peer.admin) return;
  throw Refusal(v1::CODE_PERMISSION_DENIED, "token",
                "without a token a stream is closed by the key that opened it, or by an admin");
}

}  // namespace

bool StreamRegistry::abandoned(const Stream& stream, ChangeNotifier::Clock::time_point now) const {
  const auto since = stream.session->unattended();
  return since && now - *since > lease_;
}

bool StreamRegistry::over(const Stream& stream, ChangeNotifier::Clock::time_point now) const {
  if (stream.closed && !stream.session->started()) return true;  // nobody waits for its END
  if (!stream.session->finished()) return false;
  if (abandoned(stream, now)) return true;
  return stream.closed && (stream.session->drained() || now - *stream.closed > lease_);
}

StreamRegistry::~StreamRegistry() {
  stopAll(ChangeNotifier::Clock::now());
}

void StreamRegistry::add(Stream stream) {
  std::lock_guard lock(mutex_);
  if (stopped_) {
    stream.session->stop(v1::END_REASON_DRAINING);
    throw Refusal(v1::CODE_UNAVAILABLE, {}, "the server is stopping");
  }
  sessions_.add(stream.session);
  const std::string id = stream.session->id();
  streams_.emplace(id, std::move(stream));
}

Stream StreamRegistry::find(const std::string& id, const std::string& token) const {
  std::lock_guard lock(mutex_);
  return streamOf(streams_, id, token);
}

void StreamRegistry::with(const std::string& id, const std::string& token,
                          const std::function<void(const Stream&)>& use) const {
  std::lock_guard lock(mutex_);
  use(streamOf(streams_, id, token));
}

std::vector<v1::StreamInfo> StreamRegistry::list(const Peer& peer, bool all) const {
  std::lock_guard lock(mutex_);
  std::vector<v1::StreamInfo> infos;
  for (const auto& [id, stream] : streams_) {
    if (!peer.sees(stream.user, all)) continue;
    infos.push_back(stream.info());
    infos.back().set_client(log_.nameOf(stream.user));
  }
  return infos;
}

StreamCensus StreamRegistry::census() const {
  StreamCensus census{.running = {{"lossless", 0}, {"live", 0}, {"broadcast", 0}}};
  std::lock_guard lock(mutex_);
  for (const auto& [id, stream] : streams_) {
    if (stream.session->finished()) continue;
    census.running[nameWithout("DELIVERY_", v1::Delivery_Name(stream.request->delivery()))] += 1;
    if (!stream.user.empty()) census.running_of[stream.user] += 1;
    census.lag_s = std::max(census.lag_s, stream.feed->progress().lag_s);
  }
  return census;
}

PaceLoad StreamRegistry::load(const FeedRunner* feed) const {
  std::lock_guard lock(mutex_);
  std::map<const FeedRunner*, CpuCost> feeds;
  PaceLoad load;
  for (const auto& [id, stream] : streams_) {
    CpuCost& shared = feeds[stream.feed.get()];
    shared = together(shared, stream.load());
    if (!stream.session->finished()) load.lag_s = std::max(load.lag_s, stream.feed->progress().lag_s);
  }
  for (const auto& [runner, cost] : feeds) load.total += cost.feed + cost.sensors;
  if (feed) load.feed = feeds[feed];
  return load;
}

void StreamRegistry::close(const std::string& id, const std::string& token, const Peer& peer) {
  std::lock_guard lock(mutex_);
  Stream& stream = token.empty() ? streamOf(streams_, id) : streamOf(streams_, id, token);
  if (token.empty()) requireOwner(stream, peer);
  stream.stop(v1::END_REASON_CLOSED);
  if (!stream.closed) stream.closed = ChangeNotifier::Clock::now();
  const std::string owner = peer.user == stream.user ? "" : " of " + log_.nameOf(stream.user);
  log_.info(peer.user, "closed stream " + id + owner);
}

void StreamRegistry::sweep(ChangeNotifier::Clock::time_point now) {
  std::vector<Stream> gone;  // their threads are joined once the lock is open again
  std::lock_guard lock(mutex_);
  std::erase_if(streams_, [&](auto& entry) {
    auto& [id, stream] = entry;
    if (abandoned(stream, now)) stream.stop(v1::END_REASON_ABANDONED);
    if (!over(stream, now)) return false;
    log_.info(stream.user, "stream " + id + " forgotten");
    sessions_.remove(id);
    gone.push_back(std::move(stream));
    return true;
  });
  forgotten_ += gone.size();
}

void StreamRegistry::awaitClosed(ChangeNotifier::Clock::time_point deadline) const {
  struct Ending {
    std::shared_ptr<Session> session;
    std::shared_ptr<ChangeNotifier> ended;
  };
  std::vector<Ending> closed;
  {
    std::lock_guard lock(mutex_);
    for (const auto& [id, stream] : streams_) {
      if (stream.closed) closed.push_back({stream.session, stream.feed->notifier()});
    }
  }
  for (const Ending& one : closed) one.ended->waitUntil(deadline, [&] { return one.session->finished(); });
}

bool StreamRegistry::stopAll(ChangeNotifier::Clock::time_point deadline) {
  std::map<std::string, Stream> streams;
  {
    std::lock_guard lock(mutex_);
    stopped_ = true;
    streams = streams_;
  }
  for (const auto& [id, stream] : streams) stream.stop(v1::END_REASON_DRAINING);
  bool all = true;
  for (const auto& [id, stream] : streams) {
    const Session& session = *stream.session;
    all &= stream.feed->notifier()->waitUntil(deadline, [&] { return session.settled(); });
  }
  return all;
}

}  // namespace saccade
