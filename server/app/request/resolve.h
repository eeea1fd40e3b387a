// Resolves a client's request: checks every value and fills in every default.
#pragma once

#include "app/request/measured_source.h"
#include "app/request/resolved_stream.h"
#include "scene/library/scene_library.h"

namespace saccade {

// Checks `request` against its scene and fills in what needs no loaded scene; fitTo() does the rest. Throws
// Refusal.
ResolvedStream resolve(v1::OpenStream request, const SceneEntry& scene, const MeasuredTables& tables);

// The same for a stream whose client sends the frames. fitTo() has nothing to add.
ResolvedStream resolvePushed(v1::OpenStream request);

// Comes before both: a request that leaves its rates open takes at most `most_hz`, 0.1 to 1e5.
void limitRates(double most_hz, v1::Timing& timing);

// Fits the objects with fitObjects(), and fills in the views with fitView(), and the method where lamps
// change over time. Removes disabled features that the scene lacks, so that equal feeds have equal keys.
// Throws Refusal.
void fitTo(const Scene& scene, ResolvedStream& stream);

}  // namespace saccade
