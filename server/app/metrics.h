// The page /metrics for Prometheus.
#pragma once

#include <string>

#include "app/feeds/totals.h"
#include "app/stores/scene_cache.h"
#include "app/streams/stream_registry.h"

namespace saccade {

// All metrics in the text format 0.0.4, in base units. Of clients, only the names on the list are labels.
// `clients`: null without keys.
std::string metricsText(const Totals& totals, const StreamRegistry& streams, const SceneCache& scenes,
                        const ClientKeys* clients, std::size_t viewers, bool ready);

}  // namespace saccade
