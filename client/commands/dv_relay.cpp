#include "client/commands/dv_relay.h"

#include <chrono>
#include <cstdio>

#include "client/commands/summary.h"
#include "client/formats/common/units.h"
#include "client/terminal/interrupt.h"

namespace saccade::client {
namespace {

constexpr std::chrono::milliseconds kTurn{5};  // how long a viewer waits for its turn while no events come

void checkEnd(const v1::PacketHeader& end) {
  if (end.end_reason() == v1::END_REASON_DRAINING || end.end_reason() == v1::END_REASON_ABANDONED)
    throw StreamFault(endText(end));
}

std::int64_t unixTimeUs() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::microseconds>(now).count();
}

}  // namespace

void DvRelay::run(Subscription& subscription, int sensors) {
  v1::PacketHeader end;  // the last sensor's
  for (int ended = 0; ended < sensors && !interrupted();) {
    server_.serve(std::chrono::milliseconds(0));
    const auto batch = subscription.receive(kTurn);
    reportLosses(subscription.losses());
    if (!batch || batch->header.kind() == v1::KIND_HEARTBEAT) continue;
    pass(*batch);
    if (batch->header.kind() == v1::KIND_END) ++ended, end = batch->header;
  }
  checkEnd(end);
}

void DvRelay::pass(const DecodedPacket& batch) {
  if (!epoch_us_) epoch_us_ = unixTimeUs() - batch.header.t0_ns() / kNsPerUs;
  server_.send(batch.header.sensor(), batch.events, *epoch_us_);
}

void DvRelay::reportLosses(const Losses& losses) {
  if (losses.packets == told_) return;
  told_ = losses.packets;
  printLosses(stderr, losses);
}

}  // namespace saccade::client
