// A part of a stream with packets of its own: a sensor, or a truth channel.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/request/resolved_stream.h"
#include "app/sequence/sensor_schedule.h"
#include "feed/feed_interval.h"
#include "saccade/wire/packet.h"

namespace saccade {

class Channel {
 public:
  virtual ~Channel() = default;

  std::size_t view() const { return view_; }  // the number of the one that it sees

  // Makes the packets of an interval. Takes every interval of its view from some interval on, in order, on
  // any thread. `whole`: the last packet ends with the frame that the interval ends.
  void process(const FeedInterval& interval, bool whole);

  // Of the last process():
  std::chrono::nanoseconds cost() const { return cost_; }                 // CPU time
  std::vector<Packet> takePackets() { return std::exchange(full_, {}); }  // those that are full

  std::uint64_t items() const { return items_; }           // events or samples so far
  bool catchingUp() const { return items_ < from_item_; }  // nothing is for the client yet

  virtual SensorSchedule* schedule() { return nullptr; }  // of a sensor

  // The events or samples that are in no full packet yet; with end() also the END packet, at the end of the
  // last interval. `t`, `frame`: where it has taken none.
  std::vector<Packet> flush() { return forClient(flushPackets()); }
  std::vector<Packet> end(TimeNs t, FrameIndex frame, v1::EndReason reason);

 protected:
  // Packets that end before the item with the index `from_item` are made, but not given to the client.
  Channel(std::uint64_t from_item, std::size_t view) : view_(view), from_item_(from_item) {}

  virtual std::vector<Packet> makePackets(const FeedInterval& interval) = 0;
  virtual std::vector<Packet> flushPackets() = 0;
  virtual std::vector<Packet> endPackets(TimeNs t, FrameIndex frame, v1::EndReason reason) = 0;
  virtual std::uint64_t countItems() const = 0;

 private:
  std::vector<Packet> forClient(std::vector<Packet> packets) const;

  const std::size_t view_;
  std::uint64_t from_item_, items_ = 0;
  std::optional<std::pair<TimeNs, FrameIndex>> reached_;  // the end of the last interval
  std::chrono::nanoseconds cost_{0};
  std::vector<Packet> full_;
};

// One for each sensor of the stream, then one for each of its truth channels.
std::vector<std::unique_ptr<Channel>> makeChannels(const ResolvedStream& stream, const std::string& stream_id,
                                                   std::uint64_t epoch);

}  // namespace saccade
