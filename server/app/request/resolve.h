// From a client's request to one that leaves nothing open: every default filled in, every value checked.
#pragma once

#include <optional>
#include <vector>

#include "app/request/measured_source.h"
#include "events/sensor_config.h"
#include "feed/feed.h"
#include "saccade/v1/control.pb.h"
#include "scene/library/scene_library.h"

namespace saccade {

inline constexpr int kMaxViewSide = 4096, kMaxViewPixels = 4 << 20;  // pixels
inline constexpr double kLeastEventChange = 1e-6;                    // share of the events
inline constexpr double kMinFovDeg = 1, kMaxFovDeg = 170;            // horizontal
inline constexpr int kMaxSensors = 64;
inline constexpr std::size_t kMaxCsvBytes = 8 << 20;
inline constexpr int kMaxKeyframes = 100'000;
inline constexpr double kMinTurnSeconds = 1e-3, kMaxTurnSeconds = 1e3;

struct ResolvedStream {
  v1::OpenStream request;  // as StreamOpened.resolved tells it
  FeedConfig feed;
  std::vector<SensorConfig> sensors;
  FrameIndex frames = 0;                             // intervals to render; 0: until closed
  SceneFeatures disabled_features;                   // of the scene's model
  std::optional<v1::ExpectedQuality> expected;       // where a budget was asked
  std::optional<v1::ExpectedChange> simplification;  // where needs were

  // Streams with equal keys look at the same feed.
  std::string feedKey() const;
};

// Checks `request` against its scene. The field of view may still be open, and parts of the model
// be named that the scene lacks: that is the scene's to say, see fitTo(). Throws Refusal.
ResolvedStream resolve(v1::OpenStream request, const SceneEntry& scene, const MeasuredTables& tables);

// Fills in method and bounces where the request has a budget instead, and returns what to expect of them.
// `sensors`: those of the request, resolved. Throws Refusal.
std::optional<v1::ExpectedQuality> resolveBudget(v1::OpenStream& request,
                                                 const std::vector<SensorConfig>& sensors,
                                                 const AccuracySource& accuracy);

// Fills in bounces and parts to do without where the request has needs instead, and returns what to expect of
// them. Throws Refusal.
std::optional<v1::ExpectedChange> resolveSimplification(v1::OpenStream& request,
                                                        const SimplificationSource& source);

// The parts to do without, which it puts in order. Throws Refusal.
SceneFeatures resolveDisabledFeatures(v1::Quality& quality);
void setDisabledFeatures(const SceneFeatures& parts, v1::Quality& quality);

// Fills in the field of view from the scene where the request leaves it open, and takes from `without` what
// the scene has not: it would tell equal feeds apart.
void fitTo(const Scene& scene, ResolvedStream& stream);

// Checks what needs no scene to be loaded, and fills in the defaults. Throws Refusal.
void checkTrajectory(v1::Trajectory& trajectory, const SceneEntry& scene);

// Throws Refusal naming the key.
Trajectory resolveKeyframes(const v1::Keyframes& keyframes);

// The camera's path, once the field of view is known. Throws Refusal, with the line of a faulty text.
Trajectory resolveTrajectory(const ResolvedStream& stream, const RenderScene& scene,
                             const SceneLibrary& library);

// Checks sensor `index` and fills in its defaults. Throws Refusal.
SensorConfig resolveSensor(v1::Sensor& sensor, int index, std::uint64_t stream_seed);

}  // namespace saccade
