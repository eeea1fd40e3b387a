#include "app/admission/stream_cost.h"

#include <algorithm>
#include <cmath>

#include "app/admission/limits.h"
#include "frame/image.h"
#include "stream/credit_queue.h"
#include "wire/packet_cutter.h"

namespace saccade {
namespace {

void checkMost(Limit limit, const std::string& field, double value, const Limits& limits) {
  if (value <= limits[limit]) return;
  throw LimitReached(limit, field, amountText(limit, value) + " exceed " + amountText(limit, limits[limit]));
}

// The noise of a frame fits into the bound of its events, so that its time is bounded too.
void checkNoise(const ResolvedStream& stream, std::size_t i) {
  const SensorConfig& sensor = stream.sensors[i];
  const double pixels = static_cast<double>(stream.feed.camera.width) * stream.feed.camera.height;
  const double events = noiseRate(sensor.noise) * pixels / stream.feed.frame_rate_hz;
  if (!(events > static_cast<double>(sensor.max_events_per_frame))) return;
  throw LimitReached(Limit::kEvents, "sensors[" + std::to_string(i) + "].noise",
                     std::to_string(std::llround(events)) + " noise events of a frame exceed " +
                         std::to_string(sensor.max_events_per_frame));
}

}  // namespace

// Measured on streams of 1 and 17 sensors. A sensor with all options takes three times as much as the
// plainest.
double streamMemory(const ResolvedStream& stream) {
  constexpr double kFeedBytes = 260, kSensorBytes = 24, kNoiseBytes = 28;  // per pixel
  constexpr double kEventBytes = 57;    // per event of a frame, until it is in a packet
  constexpr double kTruthBytes = 48;    // per pixel: a picture, and its copy for the packet
  constexpr double kPacketBytes = 640;  // per packet, without its events
  const FeedConfig& feed = stream.feed;
  const CameraModel& camera = feed.camera;
  const double view = static_cast<double>(camera.width) * camera.height;
  const double pixels = (camera.width + 2.0 * ImageF::kBorder) * (camera.height + 2.0 * ImageF::kBorder);
  const double packets = 1 + 1e9 / kPacketTimeNs / feed.frame_rate_hz;
  const double lens_bytes = camera.distortion.isNone() ? 0 : view * sizeof(Vec2);
  double bytes =
      pixels * kFeedBytes + lens_bytes + findMethod(feed.method)->memory(feed.params, view, feed.jitter);
  for (const SensorConfig& sensor : stream.sensors) {
    const double noise = noiseRate(sensor.noise) / feed.frame_rate_hz;
    const double events = view * (sensor.max_events_per_pixel_frame + noise);
    if (sensor.noise != NoiseConfig{})
      bytes += pixels * kNoiseBytes + kEventBytes * sensor.noise.readout_buffer;
    bytes += pixels * kSensorBytes + packets * kPacketBytes +
             kEventBytes * std::min(events, static_cast<double>(sensor.max_events_per_frame));
  }
  bytes += view * kTruthBytes * static_cast<double>(stream.truth.size());
  return bytes / (1 << 20);
}

void boundEvents(ResolvedStream& stream, const Limits& limits) {
  const double sensors = static_cast<double>(stream.sensors.size());
  const auto share = static_cast<std::uint64_t>(limits[Limit::kEvents] / sensors);
  for (std::size_t i = 0; i < stream.sensors.size(); ++i) {
    v1::Sensor& sensor = *stream.request.mutable_sensors(static_cast<int>(i));
    if (sensor.max_events_per_frame() == 0) sensor.set_max_events_per_frame(share);
    if (sensor.max_events_per_frame() > share) {
      throw LimitReached(Limit::kEvents, "sensors[" + std::to_string(i) + "].max_events_per_frame",
                         std::to_string(sensor.max_events_per_frame()) + " exceed " + std::to_string(share) +
                             " for each of the sensors");
    }
    stream.sensors[i].max_events_per_frame = sensor.max_events_per_frame();
    checkNoise(stream, i);
  }
}

void boundSteering(ResolvedStream& stream, const Limits& limits) {
  if (!stream.request.timing().steerable()) return;
  const double keys = std::min<double>(ranges::kKeyframes.max, limits[Limit::kTrajectoryPoints]);
  const auto most = static_cast<FrameIndex>(std::max(keys - 1, 1.0));
  if (stream.frames > most) {
    throw LimitReached(Limit::kTrajectoryPoints, "timing.duration_s",
                       "a stream that can be steered has at most " + std::to_string(most) + " frames");
  }
  if (stream.frames == 0) stream.frames = most;
}

std::vector<Share> sharesOf(const ResolvedStream& stream, const Limits& limits) {
  const int width = stream.feed.camera.width, height = stream.feed.camera.height;
  const int sensors = static_cast<int>(stream.sensors.size());
  return {{Limit::kStreams, 1},
          {Limit::kSensors, static_cast<double>(sensors), "sensors"},
          {Limit::kPixels, static_cast<double>(width) * height, "view"},
          {Limit::kMemory, streamMemory(stream), "view"},
          {Limit::kQueues, limits[Limit::kQueue] * (1 + CreditQueue::kKeptBounds)}};
}

void checkAlone(const v1::OpenStream& request, const Limits& limits) {
  checkMost(Limit::kFrameRate, "timing.frame_rate_hz", request.timing().frame_rate_hz(), limits);
  const std::string& csv = request.trajectory().csv();
  checkMost(Limit::kTrajectoryPoints, "trajectory.csv",
            static_cast<double>(std::count(csv.begin(), csv.end(), '\n')), limits);
  checkMost(Limit::kTrajectoryPoints, "trajectory.keyframes.keys",
            request.trajectory().keyframes().keys_size(), limits);
  const double pixel_rays = request.method().spp() * (request.quality().bounces() + 2.0);
  checkMost(Limit::kPixelRays, "method.spp", pixel_rays, limits);
  checkMost(Limit::kRays, "view", pixel_rays * request.view().width() * request.view().height(), limits);
}

}  // namespace saccade
