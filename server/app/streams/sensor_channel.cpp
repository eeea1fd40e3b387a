#include "app/streams/sensor_channel.h"

#include <algorithm>
#include <iterator>

#include "base/thread_time.h"

namespace saccade {

SensorChannel::SensorChannel(const SensorConfig& config, const PacketCutter::Source& source,
                             std::uint64_t from_event)
    : sensor_(config, static_cast<int>(source.width), static_cast<int>(source.height)),
      cutter_(source),
      from_event_(from_event) {}

void SensorChannel::process(const IntensityChange& change) {
  const auto began = threadCpuTime();
  full_.clear();
  if (!std::exchange(joined_, true) && change.frame > 1) full_.push_back(snapshot(change));
  sensor_.generate(change, output_);
  const PacketInterval interval{change.t0.count(), change.t1.count(), change.frame - 1, output_.suppressed};
  std::ranges::move(forClient(cutter_.cut(output_.events, interval)), std::back_inserter(full_));
  events_ += output_.events.size();
  cost_ = threadCpuTime() - began;
}

Packet SensorChannel::snapshot(const IntensityChange& first) {
  std::string planes = encodePlanes(sensor_.pixelsAtStart(first.I_prev));
  return cutter_.snapshot(first.t0.count(), first.frame - 1, std::move(planes));
}

std::vector<Packet> SensorChannel::end(TimeNs t, FrameIndex frame, v1::EndReason reason) {
  return forClient(cutter_.end(t.count(), frame, reason));
}

std::vector<Packet> SensorChannel::forClient(std::vector<Packet> packets) const {
  std::erase_if(packets, [&](const Packet& packet) {
    const v1::PacketHeader& header = packet.header;
    const std::uint64_t begin = header.first_event_index(), end = begin + header.count();
    return header.kind() == v1::KIND_EVENTS && begin < from_event_ && end <= from_event_;
  });
  return packets;
}

std::vector<SensorChannel> makeSensorChannels(const ResolvedStream& stream, const std::string& stream_id,
                                              std::uint64_t epoch) {
  PacketCutter::Source source{.stream_id = stream_id,
                              .epoch = epoch,
                              .width = static_cast<std::uint32_t>(stream.feed.width),
                              .height = static_cast<std::uint32_t>(stream.feed.height),
                              .codec = findCodec(stream.request.codec())};
  std::vector<SensorChannel> channels;
  for (const SensorConfig& config : stream.sensors) {
    const v1::Sensor& request = stream.request.sensors(static_cast<int>(source.sensor));
    channels.emplace_back(config, source, request.from_event());
    ++source.sensor;
  }
  return channels;
}

}  // namespace saccade
