// The resources that all streams of a server share.
#pragma once

#include <cstdint>

#include "app/admission/resource_quota.h"
#include "app/feeds/totals.h"
#include "app/request/measured_source.h"
#include "app/stores/bake_store.h"
#include "app/stores/scene_cache.h"
#include "app/streams/stream_registry.h"
#include "base/tile_pool.h"
#include "log/client_log.h"
#include "stream/client_keys.h"
#include "stream/wake_fd.h"

namespace saccade {

// References to what must outlive the streams.
struct StreamResources {
  SceneCache& scenes;
  BakeStore& bakes;
  const MeasuredTables& tables;
  TilePool& pool;
  ResourceQuota& quota;
  StreamRegistry& streams;
  WakeFd& data;       // wakes the transport of streams with credit
  WakeFd& broadcast;  // and that of broadcast streams
  Totals& totals;
  ClientLog& log;
  const ClientKeys* clients;  // null without keys
  std::uint64_t epoch;        // of the server
};

}  // namespace saccade
