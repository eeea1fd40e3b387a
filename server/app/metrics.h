// The page /metrics: what Prometheus reads.
#pragma once

#include <string>

#include "app/streams/scene_cache.h"
#include "app/streams/stream_registry.h"
#include "app/streams/totals.h"

namespace saccade {

// In the text format 0.0.4, base units, and no label that grows with the number of clients.
std::string metricsText(const Totals& totals, const StreamRegistry& streams, const SceneCache& scenes,
                        bool ready);

}  // namespace saccade
