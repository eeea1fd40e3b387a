#include "app/sequence/channel.h"

#include <algorithm>
#include <iterator>

#include "app/sequence/sensor_channel.h"
#include "app/sequence/truth_channel.h"
#include "base/thread_time.h"

namespace saccade {

void Channel::process(const FeedInterval& interval, bool whole) {
  const auto began = threadCpuTime();
  full_ = forClient(makePackets(interval));
  if (whole && interval.ends_frame) std::ranges::move(flush(), std::back_inserter(full_));
  items_ = countItems();
  reached_.emplace(interval.change.t1, interval.reachedFrame());
  cost_ = threadCpuTime() - began;
}

std::vector<Packet> Channel::end(TimeNs t, FrameIndex frame, v1::EndReason reason) {
  const auto [at, index] = reached_.value_or(std::pair(t, frame));
  return forClient(endPackets(at, index, reason));
}

std::vector<Packet> Channel::forClient(std::vector<Packet> packets) const {
  std::erase_if(packets, [&](const Packet& packet) {
    const v1::PacketHeader& header = packet.header;
    const std::uint64_t begin = header.first_event_index(), end = begin + header.count();
    const bool has_items = header.kind() == v1::KIND_EVENTS || header.kind() == v1::KIND_TRUTH;
    return has_items && begin < from_item_ && end <= from_item_;
  });
  return packets;
}

std::vector<std::unique_ptr<Channel>> makeChannels(const ResolvedStream& stream, const std::string& stream_id,
                                                   std::uint64_t epoch) {
  PacketSource source{.stream_id = stream_id,
                      .epoch = epoch,
                      .width = 0,
                      .height = 0,
                      .codec = findCodec(stream.request.codec())};
  const auto see = [&](std::size_t view) {
    source.width = static_cast<std::uint32_t>(stream.feedOf(view).camera.width);
    source.height = static_cast<std::uint32_t>(stream.feedOf(view).camera.height);
    return view;
  };
  std::vector<std::unique_ptr<Channel>> channels;
  for (std::size_t i = 0; i < stream.sensors.size(); ++i) {
    const v1::Sensor& request = stream.request.sensors(static_cast<int>(i));
    const std::size_t view = see(request.view());
    channels.push_back(std::make_unique<SensorChannel>(stream.sensors[i], source, request.from_event(),
                                                       stream.changes[i], view, request.object_ids()));
    ++source.sensor;
  }
  for (std::size_t i = 0; i < stream.truth.size(); ++i) {
    const v1::Truth& request = stream.request.truth(static_cast<int>(i));
    const std::size_t view = see(request.view());
    channels.push_back(std::make_unique<TruthChannel>(stream.truth[i], source, request.from_sample(), view));
    ++source.sensor;
  }
  return channels;
}

}  // namespace saccade
