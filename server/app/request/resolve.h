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
  v1::OpenStream request = {};                 // as StreamOpened.resolved
  FeedConfig feed = {};                        // of view 0
  std::vector<FeedConfig> further = {};        // of the further views
  std::vector<Pose> T_body_camera = {Pose{}};  // of each view
  std::vector<SensorConfig> sensors = {};
  std::vector<std::vector<SensorChange>> changes = {};  // by sensor, in order of time
  std::vector<TruthConfig> truth = {};
  FrameIndex frames = 0;  // intervals to render; 0: until closed
  SceneFeatures disabled_features = {};
  bool chooses_method = false;  // the request, or its budget; otherwise fitTo() may take another one
  std::optional<v1::ExpectedQuality> expected = {};       // of a request with a budget
  std::optional<v1::ExpectedChange> simplification = {};  // of a request with a max_event_change

  std::size_t views() const { return T_body_camera.size(); }
  const FeedConfig& feedOf(std::size_t view) const { return view == 0 ? feed : further[view - 1]; }

  // Streams with equal keys share a feed.
  std::string feedKey() const;
};

// Checks `request` against its scene and fills in what needs no loaded scene; fitTo() does the rest. Throws
// Refusal.
ResolvedStream resolve(v1::OpenStream request, const SceneEntry& scene, const MeasuredTables& tables);

// The same for a stream whose client sends the frames. fitTo() has nothing to add.
ResolvedStream resolvePushed(v1::OpenStream request);

// The parts of both. They throw Refusal.
void resolveTiming(ResolvedStream& stream);
void resolveSensors(ResolvedStream& stream);
void resolveTruths(ResolvedStream& stream);
void resolveDelivery(v1::OpenStream& request);

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

// The camera of the view at `field`; without its focal length where the request leaves that to the scene.
// Throws Refusal.
CameraModel resolveView(const v1::View& view, const std::string& field);
// Fills in the scene's field of view where the request has neither that nor intrinsics. Throws Refusal.
CameraModel fitView(const Scene& scene, v1::View& view, const std::string& field);

// Fills in the views with fitView(), and the method where light changes over time. Removes disabled features
// that the scene lacks, so that equal feeds have equal keys. Throws Refusal.
void fitTo(const Scene& scene, ResolvedStream& stream);

// Checks what needs no loaded scene, and fills in the defaults. Throws Refusal.
void checkTrajectory(v1::Trajectory& trajectory, const SceneEntry& scene);

// The name of a view in refusals.
std::string viewField(std::size_t view);
// Finds where the cameras are on the body, and checks that sensors and truth channels name a view of the
// stream. Throws Refusal.
void resolveMounts(ResolvedStream& stream);
// Renders the further views as view 0, with random numbers of their own.
void shareSettings(ResolvedStream& stream);

// Throws Refusal naming the key.
Trajectory resolveKeyframes(const v1::Keyframes& keyframes);

// The body's path, once the field of view is known. Throws Refusal, with the line of a faulty text.
Trajectory resolveTrajectory(const ResolvedStream& stream, const RenderScene& scene,
                             const SceneLibrary& library);

// Fills in the noise of a sensor, and with a preset the values of that camera. `field`: the path of the
// sensor. Throws Refusal.
NoiseConfig resolveNoise(v1::Sensor& sensor, const std::string& field);
// Fills in the fields of `noise` that are unset, and returns all of them.
NoiseConfig fillNoise(v1::Noise& noise, const NoiseConfig& defaults);

// Checks sensor `index` and fills in its defaults. Throws Refusal.
SensorConfig resolveSensor(v1::Sensor& sensor, int index, std::uint64_t stream_seed);

// Checks the changes of sensor `index`, which resolveSensor() has made `config`, and fills in their noise.
// Throws Refusal.
std::vector<SensorChange> resolveChanges(v1::Sensor& sensor, int index, const SensorConfig& config);
// The same for one change. Throws Refusal naming a member of `field`.
SensorChange resolveChange(v1::SensorChange& change, const SensorConfig& config, const std::string& field);

// Checks truth channel `index` and fills in its defaults. Throws Refusal.
TruthConfig resolveTruth(v1::Truth& truth, int index, const FeedConfig& feed, std::uint64_t stream_seed);

// Checks the IMU at `field` and fills in its defaults. Throws Refusal.
ImuConfig resolveImu(v1::Imu& imu, const std::string& field, std::uint64_t seed);

}  // namespace saccade
