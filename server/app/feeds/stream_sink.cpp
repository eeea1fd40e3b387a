#include "app/feeds/stream_sink.h"

#include <algorithm>
#include <utility>

namespace saccade {
namespace {

// A step that fails for want of memory does not keep the next one from being tried. Returns whether it
// succeeds.
template <class F>
bool attempt(const F& step) noexcept {
  try {
    step();
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

}  // namespace

StreamSink::StreamSink(std::shared_ptr<Session> session, const ResolvedStream& stream, std::uint64_t epoch,
                       std::string user)
    : session_(std::move(session)),
      channels_(makeChannels(stream, session_->id(), epoch)),
      sensors_(stream.sensors.size()),
      packet_per_frame_(stream.request.timing().packet_per_frame()),
      user_(std::move(user)) {}

void StreamSink::publish(const FeedInterval& interval, std::chrono::milliseconds lag) {
  lag_ = lag;
  session_->setLag(lag);
  deliver();
  countCost(interval.ends_frame);
  session_->setProgress(interval.reachedFrame(), interval.change.t1.count());
}

void StreamSink::deliver() {
  session_->makeRoom();
  std::uint64_t events = 0;
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    push(channels_[i]->takePackets());
    if (i < sensors_) events += channels_[i]->items();
  }
  events_ = events;
}

void StreamSink::countCost(bool ends_frame) {
  std::chrono::nanoseconds longest{0};
  for (const auto& channel : channels_) {
    frame_cost_ += channel->cost();
    longest = std::max(longest, channel->cost());
  }
  frame_longest_ += longest;
  if (!ends_frame) return;
  cost_mean_.add(seconds(std::exchange(frame_cost_, {})));
  longest_mean_.add(seconds(std::exchange(frame_longest_, {})));
  recent_s_ = cost_mean_.value();
  longest_s_ = longest_mean_.value();
}

void StreamSink::clearLag() {
  session_->setLag(lag_ = {});
}

bool StreamSink::catchingUp() const {
  return std::any_of(channels_.begin(), channels_.end(),
                     [](const auto& channel) { return channel->catchingUp(); });
}

void StreamSink::push(std::vector<Packet> packets) {
  for (Packet& packet : packets) {
    packet.header.set_lag_ms(static_cast<std::uint64_t>(lag_.count()));
    session_->push(packet);
  }
}

void StreamSink::end(TimeNs t, FrameIndex frame) {
  deliver();
  for (const auto& channel : channels_) push(channel->end(t, frame, session_->endReason()));
  session_->finish();
}

bool StreamSink::fail(const char* message) noexcept {
  bool told = true;
  for (std::uint32_t i = 0; i < session_->channels(); ++i) {
    told &= attempt([&] { push(channels_[i]->flush()); });
    told &= attempt([&] { pushError(i, message); });
  }
  session_->finish();
  return told;
}

void StreamSink::pushError(std::uint32_t channel, const std::string& message) {
  Packet packet = makeErrorPacket(session_->id(), message, session_->epoch());
  packet.header.set_sensor(channel);
  session_->push(packet);
}

}  // namespace saccade
