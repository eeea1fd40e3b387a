#include "app/sequence/truth_channel.h"

#include "base/check.h"

namespace saccade {
namespace {

const TruthChannelInfo& infoOf(const TruthConfig& config) {
  const TruthChannelInfo* info = findTruth(config.name);
  SACCADE_CHECK(info != nullptr);
  return *info;
}

}  // namespace

TruthChannel::TruthChannel(const TruthConfig& config, const PacketSource& source, std::uint64_t from_sample,
                           std::size_t view)
    : Channel(from_sample, view), info_(infoOf(config)), truth_(info_.make(config)), source_(source) {}

TruthPacker& TruthChannel::packerFrom(TimeNs t) {
  const auto planes = static_cast<std::uint32_t>(info_.planes.size());
  if (!packer_) packer_.emplace(source_, TruthPacker::Format{info_.layout, info_.element, planes}, t.count());
  return *packer_;
}

std::vector<Packet> TruthChannel::makePackets(const FeedInterval& interval) {
  const IntensityChange& change = interval.change;
  return packerFrom(change.t0).add(truth_->sample(interval), change.t1.count(), interval.reachedFrame());
}

std::vector<Packet> TruthChannel::flushPackets() {
  return packer_ ? packer_->flush() : std::vector<Packet>{};
}

// Without any interval the stream ends at t.
std::vector<Packet> TruthChannel::endPackets(TimeNs t, FrameIndex, v1::EndReason reason) {
  return packerFrom(t).end(reason);
}

}  // namespace saccade
