// The range of each number that a request chooses, for the server's checks, saccade-eval's options and help.
//
// Both ends are valid; NaN never is. A limit of the server may be narrower. Fields that are unset, and those
// whose 0 means "unset", are checked after their default is filled in. The comment names the fields of
// control.proto and noise.proto; the hygiene test `ranges` compares both and PROTOCOL.md with this table.
#pragma once

namespace saccade {

template <class T>
struct Range {
  T min, max;
};

namespace ranges {

inline constexpr Range<int> kViewSide{1, 4096};               // View.width, View.height: pixels
inline constexpr Range<double> kFovX{1, 170};                 // View.fov_x_deg: degrees
inline constexpr Range<double> kFocalLength{1, 1e6};          // Intrinsics.fx, Intrinsics.fy: pixels
inline constexpr Range<double> kPrincipalPoint{-4096, 8192};  // Intrinsics.cx, Intrinsics.cy: pixels
inline constexpr Range<double> kDistortion{-1e6, 1e6};        // Distortion.coefficients: no unit
inline constexpr Range<double> kTurn{1e-3, 1e3};              // Motion.turn_s: seconds
inline constexpr Range<double> kClearance{1e-6, 1e6};         // Motion.clearance: scene units
inline constexpr Range<int> kKeyframes{1, 100000};            // Keyframes.keys: how many
inline constexpr Range<double> kFrameRate{0.1, 1e5};          // Timing.frame_rate_hz: Hz
inline constexpr Range<double> kIntervalPx{0.01, 1000};       // Timing.interval_px: pixels
inline constexpr Range<double> kFinestPx{3e-4, 1000};         // Refinement.finest_px: pixels
inline constexpr Range<double> kRefinedThreshold{1e-3, 10};   // Refinement.threshold: log units
inline constexpr Range<double> kRefinedBias{1e-12, 1e6};      // Refinement.bias: scene luminance
inline constexpr Range<double> kDuration{0, 1e7};         // Timing.duration_s: seconds, at least one frame
inline constexpr Range<double> kSpeed{1e-3, 1e3};         // Timing.speed: stream time over wall-clock time
inline constexpr Range<int> kSpp{1, 65536};               // Method.spp: paths per pixel and frame
inline constexpr Range<int> kBounces{0, 64};              // Quality.bounces: indirect ones
inline constexpr Range<double> kBudget{1e-3, 1e6};        // Quality.budget_ms: CPU ms per frame
inline constexpr Range<double> kMaxFalseRate{0, 1e3};     // Quality.max_false_rate: per pixel-frame
inline constexpr Range<double> kMaxEventChange{1e-6, 1};  // Quality.max_event_change: share of the events
inline constexpr Range<double> kBakeError{1e-3, 1};       // Quality.bake_error: relative, of light
inline constexpr Range<int> kSensors{1, 64};              // OpenStream.sensors: how many
inline constexpr Range<double> kThreshold{1e-3, 10};      // Sensor.threshold, Sensor.threshold_off: log units
inline constexpr Range<double> kBias{1e-12, 1e6};         // Sensor.bias, Truth.bias: scene luminance
inline constexpr Range<double> kRefractory{0, 10};        // Sensor.refractory_s: seconds
inline constexpr Range<double> kCutoff{1e-4, 1e4};        // Sensor.cutoff_hz: Hz
inline constexpr Range<int> kMaxPixelEvents{1, 65536};    // Sensor.max_events_per_pixel_frame: events
inline constexpr Range<double> kArtefactOdds{0, 1};       // Sensor.max_artefact_odds: a probability
inline constexpr Range<int> kSensorChanges{0, 1000};      // Sensor.changes: how many
inline constexpr Range<double> kChangeTime{0, 1e7};       // SensorChange.time_s: seconds
inline constexpr Range<double> kLinear{-1e9, 1e9};        // CameraVelocity.linear: scene units per second
inline constexpr Range<double> kAngular{-1e3, 1e3};       // CameraVelocity.angular: radians per second
inline constexpr Range<double> kPushedIntensity{0, 1e18};  // PushFrame.intensity: scene luminance
inline constexpr Range<int> kTruth{0, 32};                 // OpenStream.truth: how many
inline constexpr Range<int> kFurtherViews{0, 7};           // OpenStream.further_views: how many
inline constexpr Range<int> kObjects{0, 64};               // OpenStream.objects: how many
inline constexpr Range<int> kTruthTimes{0, 100000};        // Truth.times_s: how many
inline constexpr Range<double> kExposure{1e-6, 100};       // Aps.exposure_s: seconds
inline constexpr Range<double> kGain{1e-9, 1e9};           // Aps.gain: per scene luminance
inline constexpr Range<double> kGamma{0.1, 10};            // Aps.gamma: a number
inline constexpr Range<double> kImuRate{1, 1e4};           // Imu.rate_hz: Hz
inline constexpr Range<double> kMetresPerUnit{1e-6, 1e6};  // Imu.metres_per_unit: metres
inline constexpr Range<double> kImuNoise{0, 1e3};          // Imu.accelerometer_noise, Imu.gyroscope_noise: SI
inline constexpr Range<double> kImuWalk{0, 1e3};           // Imu.accelerometer_walk, Imu.gyroscope_walk: SI

inline constexpr Range<double> kMismatch{0, 0.5};      // Noise.mismatch: fraction of C
inline constexpr Range<double> kBandwidth{0, 1e6};     // Noise.photoreceptor_hz, Noise.follower_hz: Hz
inline constexpr Range<double> kReference{1e-6, 1e6};  // Noise.reference_luminance: scene luminance
inline constexpr Range<double> kNoiseRate{0, 1000};    // Noise.leak_hz, Noise.shot_hz: Hz per pixel
inline constexpr Range<double> kHotRate{0, 10000};     // Noise.hot_hz: Hz per hot pixel
inline constexpr Range<double> kPixelShare{0, 1};  // Noise.hot_fraction, Noise.dead_fraction: of the pixels
inline constexpr Range<double> kJitter{0, 1};      // Noise.jitter_s: seconds
inline constexpr Range<double> kReadout{0, 1e10};  // Noise.readout_hz: events per second
inline constexpr Range<double> kReadoutBuffer{0, 65536};  // Noise.readout_buffer: events
inline constexpr Range<double> kLevelLeak{0, 1000};       // Noise.level_leak_hz: Hz per pixel
inline constexpr Range<double> kRateSpread{0, 2};         // Noise.rate_spread: natural log units
inline constexpr Range<double> kDarkLuminance{0, 1e6};    // Noise.dark_luminance: scene luminance
inline constexpr Range<double> kBrownian{0, 100};         // Noise.brownian_hz: Hz per pixel
inline constexpr Range<double> kAsymmetry{0, 1};          // Noise.asymmetry: a number

inline constexpr int kMaxViewPixels = 4 << 20;    // width times height
inline constexpr int kMaxPushedPixels = 2 << 20;  // likewise, with OpenStream.pushed
inline constexpr int kMaxCsvBytes = 8 << 20;      // Trajectory.csv, and ObjectPath.csv together

}  // namespace ranges
}  // namespace saccade
