#include "app/sequence/sensor_channel.h"

#include <algorithm>
#include <iterator>

namespace saccade {

namespace {

v1::Layout layoutOf(bool labels, bool object_ids) {
  if (object_ids) return labels ? v1::LAYOUT_LABELLED_OBJECT_COLUMNS : v1::LAYOUT_OBJECT_COLUMNS;
  return labels ? v1::LAYOUT_LABELLED_COLUMNS : v1::LAYOUT_COLUMNS;
}

}  // namespace

SensorChannel::SensorChannel(const SensorConfig& config, const PacketSource& source, std::uint64_t from_event,
                             std::vector<SensorChange> changes, std::size_t view, bool object_ids)
    : Channel(from_event, view),
      sensor_(config, static_cast<int>(source.width), static_cast<int>(source.height)),
      schedule_(std::move(changes)),
      cutter_(source, layoutOf(config.labels, object_ids)) {
  if (object_ids) objects_.emplace();
}

std::vector<Packet> SensorChannel::makePackets(const FeedInterval& interval) {
  const IntensityChange& change = interval.change;
  if (const auto due = schedule_.takeDue(change.t0, change.t1)) sensor_.change(*due);
  std::vector<Packet> full;
  if (!std::exchange(joined_, true) && change.frame > 1) full.push_back(snapshot(interval));
  sensor_.generate(change, output_);
  if (objects_) objects_->find(*interval.rendered, output_.events);
  events_ += output_.events.size();
  const PacketInterval span{change.t0.count(),  change.t1.count(), interval.frame - 1,
                            output_.suppressed, output_.artefacts, output_.lost_in_readout};
  std::ranges::move(cutter_.cut(output_.events, span), std::back_inserter(full));
  return full;
}

Packet SensorChannel::snapshot(const FeedInterval& first) {
  std::string planes = encodePlanes(sensor_.pixelsAtStart(first.change.I_prev));
  return cutter_.snapshot(first.change.t0.count(), first.frame - 1, std::move(planes));
}

std::vector<Packet> SensorChannel::endPackets(TimeNs t, FrameIndex frame, v1::EndReason reason) {
  return cutter_.end(t.count(), frame, reason);
}

}  // namespace saccade
