// A checked request, with the scenes and the light that it needs before its first frame.
#pragma once

#include <memory>

#include "app/admission/limits.h"
#include "app/request/measured_source.h"
#include "app/request/resolved_stream.h"
#include "app/stores/bake_store.h"
#include "app/stores/scene_cache.h"
#include "base/shared_build.h"
#include "scene/camera/trajectory.h"

namespace saccade {

struct StreamPlan {
  ResolvedStream resolved;
  SceneCache::ScenePtr whole = {}, scene = {};  // `scene`: as the stream changes it
  std::shared_ptr<const Bake> bake = {};        // where the stream asks for one
};

// Checks a request against the scenes there are and the limits of one stream. Throws Refusal.
StreamPlan planStream(v1::OpenStream request, const SceneLibrary& library, const MeasuredTables& tables,
                      const Limits& limits);

// Loads the scenes of a stream that renders. May take seconds. Throws Refusal, SceneError, and
// Cancelled as soon as a stop is requested.
void loadScenes(StreamPlan& plan, SceneCache& scenes, const BuildContext& context);

// Finds the light of the bake that the stream asks for, or makes it on `pool`, which may take minutes.
// `body`: the path of the body that carries the cameras. Throws Refusal, and Cancelled as soon as a stop is
// requested.
void bakeLight(StreamPlan& plan, const Trajectory& body, BakeStore& bakes, TilePool& pool,
               const BuildContext& context);

}  // namespace saccade
