// Resolves what a request says of quality: budgets, simplification, disabled features.
#pragma once

#include <optional>
#include <vector>

#include "app/request/measured_source.h"
#include "events/sensor_config.h"
#include "render/features/simplify.h"

namespace saccade {

// Replaces a budget by method, spp and bounces, and returns the quality to expect; nothing without a budget.
// `sensors`: those of the request, resolved. Throws Refusal.
std::optional<v1::ExpectedQuality> resolveBudget(v1::OpenStream& request,
                                                 const std::vector<SensorConfig>& sensors,
                                                 const AccuracySource& accuracy);

// Replaces max_event_change by bounces and disabled features, and returns the change to expect; nothing where
// it is not set. Throws Refusal.
std::optional<v1::ExpectedChange> resolveSimplification(v1::OpenStream& request,
                                                        const SimplificationSource& source);

// The disabled features, which it sorts and makes unique in `quality`. Throws Refusal.
SceneFeatures resolveDisabledFeatures(v1::Quality& quality);
void setDisabledFeatures(const SceneFeatures& features, v1::Quality& quality);

}  // namespace saccade
