// A sensor of a stream, and the packets that its events fill.
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
  // What ends before the event of the index `from_event` is made, but kept from the client.
  SensorChannel(const SensorConfig& config, const PacketCutter::Source& source, std::uint64_t from_event);

  // Takes every interval from its first on, in order; on any thread. Where something came before the first,
  // its packets begin with a snapshot of the pixels.
  void look(const IntensityChange& change);

  std::chrono::nanoseconds cost() const { return cost_; }                 // CPU time of the last look()
  std::uint64_t events() const { return events_; }                        // that look() has made so far
  bool catchingUp() const { return events_ < from_event_; }               // none is for the client yet
  std::vector<Packet> takePackets() { return std::exchange(full_, {}); }  // full ones, for the client

  // What is in no full packet yet, and with end() the last packet of all.
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
