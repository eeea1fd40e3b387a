// The page /metrics for Prometheus.
#pragma once

#include <string>

#include "app/feeds/totals.h"
#include "app/stores/scene_cache.h"
#include "app/streams/stream_registry.h"

namespace saccade {

// All metrics in the text format 0.0.4, in base units. No label grows with the number of clients.
std::string metricsText(const Totals& totals, const StreamRegistry& streams, const SceneCache& scenes,
                        std::size_t viewers, bool ready);

}  // namespace saccade
