// One sensor of a stream, and the packets of its events.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/sequence/channel.h"
#include "events/sensor.h"
#include "saccade/wire/packet_cutter.h"
#include "truth/event_objects.h"

namespace saccade {

class SensorChannel final : public Channel {
 public:
  // `changes`: in order of time.
  SensorChannel(const SensorConfig& config, const PacketSource& source, std::uint64_t from_event,
                std::vector<SensorChange> changes = {}, std::size_t view = 0, bool object_ids = false);
  SensorSchedule* schedule() override { return &schedule_; }

 protected:
  // Where the feed is already past its first interval, the packets begin with a snapshot of the pixels.
  std::vector<Packet> makePackets(const FeedInterval& interval) override;
  std::vector<Packet> flushPackets() override { return cutter_.flush(); }
  std::vector<Packet> endPackets(TimeNs t, FrameIndex frame, v1::EndReason reason) override;
  std::uint64_t countItems() const override { return events_; }

 private:
  Packet snapshot(const FeedInterval& first);

  Sensor sensor_;
  std::optional<EventObjects> objects_;  // where they are asked for
  SensorSchedule schedule_;
  PacketCutter cutter_;
  std::uint64_t events_ = 0;
  bool joined_ = false;
  SensorOutput output_;
};

}  // namespace saccade
