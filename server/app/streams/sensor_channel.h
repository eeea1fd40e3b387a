// One sensor of a stream, and the packets of its events.
#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "app/request/resolve.h"
#include "events/sensor.h"
#include "wire/packet_cutter.h"

namespace saccade {

class SensorChannel {
 public:
  // Packets that end before the event with the index `from_event` are made, but not given to the client.
  SensorChannel(const SensorConfig& config, const PacketCutter::Source& source, std::uint64_t from_event);

  // Makes the events of an interval. Takes every interval of the feed from some interval on, in order, on any
  // thread. Where the feed is already past its first interval, the packets begin with a snapshot of the
  // pixels.
  void process(const IntensityChange& change);

  // Of the last process():
  std::chrono::nanoseconds cost() const { return cost_; }                 // CPU time
  std::vector<Packet> takePackets() { return std::exchange(full_, {}); }  // those that are full
  // Of all so far:
  std::uint64_t events() const { return events_; }
  bool catchingUp() const { return events_ < from_event_; }  // no event is for the client yet

  // The events that are in no full packet yet; with end() also the END packet.
  std::vector<Packet> flush() { return forClient(cutter_.flush()); }
  std::vector<Packet> end(TimeNs t, FrameIndex frame, v1::EndReason reason);

 private:
  Packet snapshot(const IntensityChange& first);
  std::vector<Packet> forClient(std::vector<Packet> packets) const;

  Sensor sensor_;
  PacketCutter cutter_;
  std::uint64_t from_event_, events_ = 0;
  bool joined_ = false;
  std::chrono::nanoseconds cost_{0};
  SensorOutput output_;
  std::vector<Packet> full_;
};

// One for each sensor of the stream.
std::vector<SensorChannel> makeSensorChannels(const ResolvedStream& stream, const std::string& stream_id,
                                              std::uint64_t epoch);

}  // namespace saccade
