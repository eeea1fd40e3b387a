// The amounts that all clients together hold of the limits of a server now.
#pragma once

#include <cstddef>

#include "app/admission/resource_quota.h"
#include "app/stores/bake_store.h"
#include "app/stores/scene_cache.h"
#include "app/streams/stream_registry.h"

namespace saccade {

// Where that is known.
struct LimitHolders {
  const ResourceQuota& quota;
  const SceneCache& scenes;
  const BakeStore& bakes;
  const StreamRegistry& streams;
  const TilePool& pool;
  std::size_t viewers;
};

// Sets LimitInfo.used, to a thousandth of the unit, where all clients together hold something of a limit.
// `description`: with all limits, see describeLimits(). From any thread.
void describeUse(const LimitHolders& holders, v1::ServerDescription& description);

}  // namespace saccade
