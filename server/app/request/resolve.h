// Resolves a client's request: checks every value and fills in every default.
#pragma once

#include <optional>
#include <vector>

#include "app/request/measured_source.h"
#include "events/noise/presets.h"
#include "events/sensor_config.h"
#include "feed/feed.h"
#include "saccade/v1/control.pb.h"
#include "scene/library/scene_library.h"
#include "truth/truth_source.h"

namespace saccade {

struct ResolvedStream {
  v1::OpenStream request;  // as StreamOpened.resolved
  FeedConfig feed;
  std::vector<SensorConfig> sensors;
  std::vector<std::vector<SensorChange>> changes;  // by sensor, in order of time
  std::vector<TruthConfig> truth;
  FrameIndex frames = 0;  // intervals to render; 0: until closed
  SceneFeatures disabled_features;
  std::optional<v1::ExpectedQuality> expected;       // of a request with a budget
  std::optional<v1::ExpectedChange> simplification;  // of a request with a max_event_change

  // Streams with equal keys share a feed.
  std::string feedKey() const;
};

// Checks `request` against its scene and fills in what needs no loaded scene; fitTo() does the rest. Throws
// Refusal.
ResolvedStream resolve(v1::OpenStream request, const SceneEntry& scene, const MeasuredTables& tables);

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

// The camera of a view; without its focal length where the request leaves that to the scene. Throws Refusal.
CameraModel resolveView(const v1::View& view);
// Fills in the scene's field of view where the request has neither that nor intrinsics. Throws Refusal.
CameraModel fitView(const Scene& scene, v1::View& view);

// Fills in the view with fitView(). Removes disabled features that the
// scene lacks, so that equal feeds have equal keys. Throws Refusal.
void fitTo(const Scene& scene, ResolvedStream& stream);

// Checks what needs no loaded scene, and fills in the defaults. Throws Refusal.
void checkTrajectory(v1::Trajectory& trajectory, const SceneEntry& scene);

// Throws Refusal naming the key.
Trajectory resolveKeyframes(const v1::Keyframes& keyframes);

// The camera's path, once the field of view is known. Throws Refusal, with the line of a faulty text.
Trajectory resolveTrajectory(const ResolvedStream& stream, const RenderScene& scene,
                             const SceneLibrary& library);

// Fills in the noise of a sensor, and with a preset the values of that camera. `field`: the path of the
// sensor. Throws Refusal.
NoiseConfig resolveNoise(v1::Sensor& sensor, const std::string& field);

// Checks sensor `index` and fills in its defaults. Throws Refusal.
SensorConfig resolveSensor(v1::Sensor& sensor, int index, std::uint64_t stream_seed);

// The changes of sensor `index`, which resolveSensor() has made `config`. Throws Refusal.
std::vector<SensorChange> resolveChanges(const v1::Sensor& sensor, int index, const SensorConfig& config);
// Checks one change of a sensor that is `config` at that time. Throws Refusal naming a member of `field`.
SensorChange readChange(const v1::SensorChange& change, const SensorConfig& config, const std::string& field);

// Checks truth channel `index` and fills in its defaults. Throws Refusal.
TruthConfig resolveTruth(v1::Truth& truth, int index, const FeedConfig& feed);

}  // namespace saccade
