// The rig of a stream: a feed for each of its views.
#pragma once

#include <map>
#include <memory>

#include "app/request/resolved_stream.h"
#include "feed/bake_plan.h"
#include "feed/rig.h"

namespace saccade {

// Renders frame 0 of each view on `pool`. `body`: the path of the body that carries the cameras. `steered`:
// paths of objects by the numbers of their bodies, instead of those of the stream.
Rig makeRig(const std::shared_ptr<const RenderScene>& scene, const Trajectory& body,
            const ResolvedStream& stream, const PoolHandle& pool,
            const std::map<std::size_t, Trajectory>& steered = {});

// The plan of a bake for all views. Throws Refusal.
BakePlan planBakeOf(const RenderScene& scene, const Trajectory& body, const ResolvedStream& stream);

}  // namespace saccade
