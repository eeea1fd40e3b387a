#include "app/streams/stream_sink.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <utility>

namespace saccade {
namespace {

// A step that fails for want of memory does not keep the next one from being tried.
template <class F>
void attempt(const F& step) noexcept {
  try {
    step();
  } catch (const std::exception& fault) {
    spdlog::error("a stream that fails cannot be told so: {}", fault.what());
  }
}

}  // namespace

StreamSink::StreamSink(std::shared_ptr<Session> session, const ResolvedStream& stream, std::uint64_t epoch)
    : session_(std::move(session)),
      channels_(makeChannels(stream, session_->id(), epoch)),
      sensors_(stream.sensors.size()),
      packet_per_frame_(stream.request.timing().packet_per_frame()) {}

void StreamSink::publish(const IntensityChange& change, std::chrono::milliseconds lag) {
  lag_ = lag;
  session_->setLag(lag);
  std::uint64_t events = 0;
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    push(channels_[i]->takePackets());
    if (i < sensors_) events += channels_[i]->items();
  }
  events_ = events;
  countCost();
  session_->setProgress(change.frame, change.t1.count());
}

void StreamSink::countCost() {
  std::chrono::nanoseconds sum{0}, longest{0};
  for (const auto& channel : channels_) {
    sum += channel->cost();
    longest = std::max(longest, channel->cost());
  }
  cost_mean_.add(seconds(sum));
  longest_mean_.add(seconds(longest));
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
  for (const auto& channel : channels_) push(channel->end(t, frame, session_->endReason()));
  session_->finish();
}

void StreamSink::fail(const char* message) noexcept {
  for (std::uint32_t i = 0; i < session_->channels(); ++i) {
    attempt([&] { push(channels_[i]->flush()); });
    attempt([&] { pushError(i, message); });
  }
  session_->finish();
}

void StreamSink::pushError(std::uint32_t channel, const std::string& message) {
  Packet packet = makeErrorPacket(session_->id(), message, session_->epoch());
  packet.header.set_sensor(channel);
  session_->push(packet);
}

}  // namespace saccade
