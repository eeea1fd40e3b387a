#include "saccade/subscription.h"

#include <algorithm>
#include <utility>

#include "saccade/retry.h"

namespace saccade::client {
namespace {

using std::chrono::milliseconds;

constexpr const char* kConnectionLost = "the connection to the server is lost";

// Removes from a packet what arrived before.
void cutOff(const SequenceCheck::FreshRange& fresh, DecodedPacket& batch) {
  const auto known = static_cast<std::ptrdiff_t>(fresh.known_items);
  if (!batch.events.empty()) batch.events.erase(batch.events.begin(), batch.events.begin() + known);
  if (!batch.truth.empty()) batch.truth.erase(batch.truth.begin(), batch.truth.begin() + known);
  v1::PacketHeader& header = batch.header;
  const bool earlier = !batch.events.empty() && batch.events.front().t_ns < fresh.t0_ns;
  Withheld withheld = withheldOf(header);
  if (earlier || !withheld.covers(fresh.known_withheld)) {
    throw StreamFault("the stream does not come out as it did before it was lost");
  }
  header.set_first_event_index(header.first_event_index() + fresh.known_items);
  header.set_count(header.count() - static_cast<std::uint32_t>(fresh.known_items));
  header.set_t0_ns(fresh.t0_ns);
  withheld -= fresh.known_withheld;
  header.set_suppressed(withheld.suppressed);
  header.set_artefacts(withheld.artefacts);
  header.set_lost_in_readout(withheld.lost_in_readout);
}

}  // namespace

Subscription::Subscription(zmq::context_t& context, StreamHandle& stream, RetryPolicy retry_policy)
    : context_(context),
      stream_(stream),
      retry_policy_(std::move(retry_policy)),
      sequence_(stream.opened().resolved()) {
  connect();
}

void Subscription::connect() {
  // A SUB socket reconnects by itself and misses less than a new one.
  if (!connection_ || !broadcast()) {
    connection_.emplace(stream_.subscribe(context_, sequence_.seqs()));
  }
  heard_ = false;
  last_heard_ = Clock::now();
}

std::optional<DecodedPacket> Subscription::receive(milliseconds timeout) {
  const auto until = Clock::now() + timeout;
  while (true) {
    const auto left = std::min(until, last_heard_ + retry_policy_.silence) - Clock::now();
    auto batch = receiveFromConnection(std::max(milliseconds(0), std::chrono::ceil<milliseconds>(left)));
    if (batch && take(*batch)) return batch;
    if (batch) continue;
    if (Clock::now() - last_heard_ >= retry_policy_.silence) reconnect();
    return std::nullopt;
  }
}

std::optional<DecodedPacket> Subscription::receiveFromConnection(milliseconds timeout) {
  try {
    return connection_->receive(timeout);
  } catch (const StreamRefused& refused) {
    if (heard_ && refused.connection_only) {
      connect();
    } else {
      startAgain(refused.what());
    }
    return std::nullopt;
  }
}

// Whether the batch has something new for the caller.
bool Subscription::take(DecodedPacket& batch) {
  found();
  heard_ = true;
  last_heard_ = Clock::now();
  if (batch.header.kind() == v1::KIND_HEARTBEAT) return true;
  if (endsEarly(batch.header)) {
    startAgain(endText(batch.header));
    return false;
  }
  const auto fresh = sequence_.add(batch.header);
  if (!fresh) return false;
  if (stream_.delivery() == v1::DELIVERY_LOSSLESS && losses().gaps > 0) {
    throw StreamFault("packets of a LOSSLESS stream are missing");
  }
  cutOff(*fresh, batch);
  failure_.clear();
  lost_for_ = {};
  return true;
}

// Whether the server ended the stream before its last frame, and it can be opened again.
bool Subscription::endsEarly(const v1::PacketHeader& header) const {
  const bool left =
      header.end_reason() == v1::END_REASON_DRAINING || header.end_reason() == v1::END_REASON_ABANDONED;
  const std::uint64_t frames = stream_.opened().frames();
  const bool last_frame = frames > 0 && header.frame() >= frames;
  return left && !last_frame && mayStartAgain();
}

// Called after silence. Tries a new connection first; if that is silent too, asks the server for the stream.
void Subscription::reconnect() {
  const auto until = giveUpAt(kConnectionLost);  // begins the loss, so it comes before the clock
  if (Clock::now() >= until) throw StreamFault(kConnectionLost);
  if (heard_ && !broadcast()) return connect();
  std::optional<v1::StreamInfo> info;
  retryAfter(kConnectionLost, [&](milliseconds) { info = stream_.info(retry_policy_.waiting); });
  if (!info) return startAgain("the server no longer knows the stream");
  const std::uint64_t frames = stream_.opened().frames();
  if (broadcast() && frames > 0 && info->frames_done() >= frames) {
    throw StreamFault("the end of the stream was lost");
  }
  connect();
}

void Subscription::startAgain(const std::string& failure) {
  if (ownFrames())
    throw StreamFault(failure + "; a stream that its client steers or pushes is not opened again");
  if (!mayStartAgain()) throw StreamFault(failure);
  const std::uint64_t epoch = stream_.opened().epoch();
  retryAfter(failure, [&](milliseconds deadline) {
    stream_.reopen(sequence_.items(), deadline, retry_policy_.waiting);
  });
  // Nothing new has arrived since the last failure, and no restart explains this one.
  if (failure == failure_ && stream_.opened().epoch() == epoch) throw StreamFault(failure);
  failure_ = failure;
  found();
  sequence_.restart();
  connect();
}

bool Subscription::mayStartAgain() const {
  const bool again = stream_.delivery() == v1::DELIVERY_LOSSLESS && !ownFrames();
  return again && !stream_.closed() && retry_policy_.retry_time.count() > 0;
}

void Subscription::retryAfter(const std::string& loss, const std::function<void(milliseconds)>& attempt) {
  try {
    retry(attempt, {.until = giveUpAt(loss), .waiting = retry_policy_.waiting, .mayPass = isShortage});
  } catch (const NoAnswer& silence) {
    throw StreamFault(loss + ", and " + silence.what());
  }
}

// When the retry time ends. It runs while the server is lost, and begins anew with new data.
Subscription::Clock::time_point Subscription::giveUpAt(const std::string& loss) {
  if (!lost_since_) {
    lost_since_ = Clock::now();
    if (retry_policy_.lost && retry_policy_.retry_time.count() > 0) retry_policy_.lost(loss);
  }
  return *lost_since_ + retry_policy_.retry_time - lost_for_;
}

// After a loss. The silence before it counts, too.
void Subscription::found() {
  if (lost_since_) lost_for_ += Clock::now() - std::min(*lost_since_, last_heard_);
  lost_since_.reset();
}

}  // namespace saccade::client
