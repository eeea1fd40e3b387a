// Hands the events of a stream to the viewers of a DvServer.
#pragma once

#include <cstdint>
#include <optional>

#include "client/dv/dv_server.h"
#include "saccade/subscription.h"

namespace saccade::client {

class DvRelay {
 public:
  // `epoch_us`: Unix time of stream time 0; by default the first events have the present time.
  DvRelay(dv::DvServer& server, std::optional<std::int64_t> epoch_us)
      : server_(server), epoch_us_(epoch_us) {}

  // Returns when all `sensors` have ended, or after Ctrl-C. Lost packets are told on stderr. Throws
  // StreamFault if the server ends the stream early, and as Subscription does.
  void run(Subscription& subscription, int sensors);

 private:
  void pass(const DecodedPacket& batch);
  void reportLosses(const Losses& losses);

  dv::DvServer& server_;
  std::optional<std::int64_t> epoch_us_;
  std::uint64_t told_ = 0;  // lost packets
};

}  // namespace saccade::client
