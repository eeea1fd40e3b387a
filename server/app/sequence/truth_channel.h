// One truth channel of a stream, and the packets of its samples.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/sequence/channel.h"
#include "saccade/wire/truth_packer.h"
#include "truth/truth_source.h"

namespace saccade {

class TruthChannel final : public Channel {
 public:
  TruthChannel(const TruthConfig& config, const PacketSource& source, std::uint64_t from_sample,
               std::size_t view = 0);

 protected:
  std::vector<Packet> makePackets(const FeedInterval& interval) override;
  std::vector<Packet> flushPackets() override;
  std::vector<Packet> endPackets(TimeNs t, FrameIndex frame, v1::EndReason reason) override;
  std::uint64_t countItems() const override { return packer_ ? packer_->samples() : 0; }

 private:
  TruthPacker& packerFrom(TimeNs t);

  const TruthChannelInfo& info_;
  std::unique_ptr<TruthSource> truth_;
  PacketSource source_;
  std::optional<TruthPacker> packer_;  // once the first interval is known
};

}  // namespace saccade
