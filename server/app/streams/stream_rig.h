// The rig of a stream: a feed for each of its views.
#pragma once

#include <memory>

#include "app/request/resolve.h"
#include "app/streams/feed_runner.h"
#include "feed/bake_plan.h"
#include "feed/rig.h"

namespace saccade {

// Renders frame 0 of each view on `pool`. `body`: the path of the body that carries the cameras.
Rig makeRig(const std::shared_ptr<const RenderScene>& scene, const Trajectory& body,
            const ResolvedStream& stream, const PoolHandle& pool);

// `body`: the path of `rig`. `frames`: those of the stream; 0: it has no end. Call it before any step.
FeedFacts factsOf(const Rig& rig, const Trajectory& body, FrameIndex frames);

// The plan of a bake for all views. Throws Refusal.
BakePlan planBakeOf(const RenderScene& scene, const Trajectory& body, const ResolvedStream& stream);

}  // namespace saccade
