#include "app/limit_use.h"

#include <cmath>

#include "app/feeds/pace.h"
#include "base/mebibyte.h"

namespace saccade {
namespace {

constexpr Limit kOfTheQuota[]{Limit::kStreams,  Limit::kSensors, Limit::kPixels,
                              Limit::kRequests, Limit::kMemory,  Limit::kQueues};

// % of the threads.
double paceShare(const LimitHolders& holders) {
  return 100 * holders.streams.load(nullptr).total / cpuSupply(holders.pool).threads;
}

}  // namespace

void describeUse(const LimitHolders& holders, v1::ServerDescription& description) {
  const auto tell = [&](Limit limit, double amount) {
    description.mutable_limits(static_cast<int>(limit))->set_used(std::round(amount * 1e3) / 1e3);
  };
  for (const Limit limit : kOfTheQuota) tell(limit, holders.quota.taken(limit));
  const SceneUse scenes = holders.scenes.inUse();
  tell(Limit::kScenes, static_cast<double>(scenes.bytes) / kMiB);
  tell(Limit::kReducedScenes, scenes.variants);
  tell(Limit::kBakes, holders.bakes.inUse());
  tell(Limit::kViewers, static_cast<double>(holders.viewers));
  tell(Limit::kCpu, paceShare(holders));
}

}  // namespace saccade
