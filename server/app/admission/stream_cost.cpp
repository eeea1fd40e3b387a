#include "app/admission/stream_cost.h"

#include <algorithm>
#include <cmath>

#include "app/admission/limits.h"
#include "app/admission/queue_cost.h"
#include "app/request/refusal.h"
#include "app/request/request_memory.h"
#include "base/mebibyte.h"
#include "feed/refined_tile.h"
#include "frame/intensity_change.h"
#include "saccade/wire/packet_cutter.h"
#include "truth/truth_source.h"

namespace saccade {
namespace {

void checkMost(Limit limit, const std::string& field, double value, const Limits& limits) {
  if (value <= limits[limit]) return;
  throw LimitReached(limit, field, amountText(limit, value) + " exceed " + amountText(limit, limits[limit]));
}

double pixelsWithBorder(const FeedConfig& feed) {
  return (feed.camera.width + 2.0 * ImageF::kBorder) * (feed.camera.height + 2.0 * ImageF::kBorder);
}

double pixelsOf(const v1::View& view) {
  return static_cast<double>(view.width()) * view.height();
}

// Of all views.
double pixelsOf(const v1::OpenStream& request) {
  double sum = pixelsOf(request.view());
  for (const v1::View& view : request.further_views()) sum += pixelsOf(view);
  return sum;
}

const FeedConfig& feedOfSensor(const ResolvedStream& stream, std::size_t sensor) {
  return stream.feedOf(stream.request.sensors(static_cast<int>(sensor)).view());
}

double pixelsOf(const v1::OpenStream& request, std::uint32_t view) {
  return pixelsOf(view == 0 ? request.view() : request.further_views(static_cast<int>(view) - 1));
}

// Noise events of a pixel in a frame.
double noisePerFrame(const NoiseConfig& noise, double rate_hz) {
  return noiseRate(noise) / rate_hz;
}

// Noise events of a pixel in a frame for which every sensor has room, so that its noise may change.
constexpr double kNoiseRoom = 1;
double noiseRoom(const NoiseConfig& first, double rate_hz) {
  return std::max(kNoiseRoom, noisePerFrame(first, rate_hz));
}
double bufferRoom(const NoiseConfig& first) {
  return std::max(NoiseConfig().readout_buffer, first.readout_buffer);
}

// The noise of a frame fits into the bound of its events, so that its time is bounded too.
void checkNoise(const v1::OpenStream& request, const v1::Sensor& sensor, const NoiseConfig& noise,
                const std::string& field) {
  const double events =
      noisePerFrame(noise, request.timing().frame_rate_hz()) * pixelsOf(request, sensor.view());
  if (!(events > static_cast<double>(sensor.max_events_per_frame()))) return;
  throw LimitReached(Limit::kEvents, field,
                     std::to_string(std::llround(events)) + " noise events of a frame exceed " +
                         std::to_string(sensor.max_events_per_frame()));
}

// Of a client's frames: those that wait, and two intervals between them.
double pushedBytes(const FeedConfig& feed, const Limits& limits) {
  const double planes = 2.0 * kChangePlanes.size() + limits[Limit::kPushes];
  return pixelsWithBorder(feed) * sizeof(float) * planes;
}

// Per pixel: log brightness at both ends, updates of tiles, whose lists may grow to twice as much, and those
// of two intervals.
double refinedBytes(const FeedConfig& feed) {
  if (!feed.refinement) return 0;
  return 2 * sizeof(float) + 4 * feed.refinement->most_updates * sizeof(IntensityUpdate);
}

double feedBytes(const FeedConfig& feed, bool moves) {
  constexpr double kFeedBytes = 260;  // per pixel
  const double lens_bytes = feed.camera.distortion.isNone() ? 0 : feed.pixels() * sizeof(Vec2);
  return pixelsWithBorder(feed) * (kFeedBytes + refinedBytes(feed)) + lens_bytes +
         findMethod(feed.method)->memory(feed.params, {feed.pixels(), feed.jitter, moves});
}

// Keys of paths that the scene gives objects.
double ownPathBytes(const ResolvedStream& stream) {
  constexpr double kKeyBytes = 250;
  double keys = 0;
  for (const ResolvedObject& object : stream.objects) keys += static_cast<double>(object.own_poses);
  return keys * kKeyBytes;
}

// Of objects that move: the number of the one that a pixel shows, in two frames. Their places, lamps and
// deformed shapes are also kept at times within a refined interval.
double objectBytes(const FeedConfig& feed, const ResolvedStream& stream) {
  constexpr double kFrames = 2, kObjectBytes = 16 << 10;  // of a place
  const double times = kFrames + (feed.refinement ? RefinedInterval::kMostPieces : 0);
  const double objects = static_cast<double>(stream.objects.size());
  if (objects == 0) return 0;
  return kFrames * pixelsWithBorder(feed) * sizeof(std::uint32_t) +
         times * (kObjectBytes * objects + stream.shape_bytes) + ownPathBytes(stream);
}

}  // namespace

double feedMemory(const ResolvedStream& stream, const Limits& limits) {
  double bytes = 0;
  for (std::size_t i = 0; i < stream.views(); ++i) {
    const FeedConfig& feed = stream.feedOf(i);
    bytes += stream.request.pushed() ? pushedBytes(feed, limits)
                                     : feedBytes(feed, !stream.objects.empty()) + objectBytes(feed, stream);
  }
  return bytes / kMiB;
}

// Measured on streams of 1 and 17 sensors. A sensor with all options takes three times as much as the
// plainest.
double streamMemory(const ResolvedStream& stream, const Limits& limits) {
  constexpr double kSensorBytes = 24, kNoiseBytes = 28;  // per pixel
  constexpr double kSpreadBytes = 36;                    // per pixel, where its rates are its own
  constexpr double kPieceBytes = 20;                     // per pixel, where an interval may hold updates
  constexpr double kEventBytes = 57;                     // per event of a frame, until it is in a packet
  constexpr double kTruthBytes = 48;                     // per pixel: a picture, and its copy for the packet
  constexpr double kRowBytes = 400;                      // likewise: a row of a frame
  constexpr double kPacketBytes = 640;                   // per packet, without its events
  const double rate_hz = stream.feed.frame_rate_hz, packets = 1 + 1e9 / kPacketTimeNs / rate_hz;
  double bytes = 0;
  for (std::size_t i = 0; i < stream.sensors.size(); ++i) {
    const SensorConfig& sensor = stream.sensors[i];
    const FeedConfig& view = feedOfSensor(stream, i);
    const double events =
        view.pixels() * (sensor.max_events_per_pixel_frame + noiseRoom(sensor.noise, rate_hz));
    const double spread_bytes = sensor.noise.rate_spread > 0 ? kSpreadBytes : 0;
    const double piece_bytes = view.intervals.followMotion() ? kPieceBytes : 0;
    bytes += pixelsWithBorder(view) * (kSensorBytes + kNoiseBytes + spread_bytes + piece_bytes) +
             packets * kPacketBytes +
             kEventBytes * (std::min(events, static_cast<double>(sensor.max_events_per_frame)) +
                            bufferRoom(sensor.noise));
  }
  for (const v1::Truth& truth : stream.request.truth())
    bytes += stream.feedOf(truth.view()).pixels() * kTruthBytes;
  for (const TruthConfig& truth : stream.truth) bytes += rowsOfFrame(truth) * kRowBytes;
  return feedMemory(stream, limits) + bytes / kMiB;
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
    const std::string field = "sensors[" + std::to_string(i) + "]";
    checkNoise(stream.request, sensor, stream.sensors[i].noise, field + ".noise");
    for (std::size_t k = 0; k < stream.changes[i].size(); ++k)
      checkChange(stream.request, sensor, stream.sensors[i].noise, stream.changes[i][k],
                  field + ".changes[" + std::to_string(k) + "]");
  }
}

void checkChange(const v1::OpenStream& request, const v1::Sensor& sensor, const NoiseConfig& first,
                 const SensorChange& change, const std::string& field) {
  if (!change.noise) return;
  const double rate_hz = request.timing().frame_rate_hz();
  if (noisePerFrame(*change.noise, rate_hz) > noiseRoom(first, rate_hz))
    refuse(field + ".noise", "a pixel has room for " + std::to_string(noiseRoom(first, rate_hz)) +
                                 " noise events in a frame, as the sensor is opened");
  if (change.noise->readout_buffer > bufferRoom(first))
    refuse(field + ".noise.readout_buffer", "as the sensor is opened, at most " +
                                                std::to_string(std::llround(bufferRoom(first))) +
                                                " events can wait");
  checkNoise(request, sensor, *change.noise, field + ".noise");
}

void boundSteering(ResolvedStream& stream, const Limits& limits) {
  if (!stream.request.timing().steerable()) return;
  const double keys = std::min<double>(ranges::kKeyframes.max, limits[Limit::kTrajectoryPoints]);
  const double paths = 1.0 + stream.request.objects_size();
  const auto most = static_cast<FrameIndex>(std::max(std::floor(keys / paths) - 1, 1.0));
  if (stream.frames > most) {
    throw LimitReached(Limit::kTrajectoryPoints, "timing.duration_s",
                       "a stream that can be steered has at most " + std::to_string(most) + " frames");
  }
  if (stream.frames == 0) stream.frames = most;
}

void boundRows(const ResolvedStream& stream, const Limits& limits) {
  double rows = 0;
  for (const TruthConfig& truth : stream.truth) rows += rowsOfFrame(truth);
  checkMost(Limit::kRows, "truth", rows, limits);
}

std::vector<Share> sharesOf(const ResolvedStream& stream, const Limits& limits) {
  const int sensors = static_cast<int>(stream.sensors.size());
  const double views = static_cast<double>(stream.views());
  std::vector<Share> shares{
      {Limit::kStreams, 1},
      {Limit::kSensors, static_cast<double>(sensors), "sensors"},
      {Limit::kPixels, pixelsOf(stream.request), "view"},
      {Limit::kMemory, streamMemory(stream, limits) - feedMemory(stream, limits), "view"},
      {Limit::kMemory, pathMemory(stream.request.trajectory()) * views, "trajectory"},
      {Limit::kMemory, objectMemory(stream.request) * views, "objects"},
      {Limit::kQueues, queueMemory(stream, limits)}};
  if (stream.request.timing().steerable())
    shares.push_back({Limit::kMemory,
                      steeringMemory(stream.frames) * views * (1.0 + stream.request.objects_size()),
                      "timing"});
  return shares;
}

void checkAlone(const v1::OpenStream& request, const Limits& limits) {
  checkMost(Limit::kFrameRate, "timing.frame_rate_hz", request.timing().frame_rate_hz(), limits);
  checkMost(Limit::kFrameRate, "timing.max_rate_hz", request.timing().max_rate_hz(), limits);
  const v1::Trajectory& path = request.trajectory();
  checkMost(Limit::kTrajectoryPoints, path.has_csv() ? "trajectory.csv" : "trajectory.keyframes.keys",
            pointsOf(path), limits);
  checkMost(Limit::kTrajectoryPoints, "objects", pointsOf(path) + objectPoints(request), limits);
  const double pixel_rays = request.method().spp() * (request.quality().bounces() + 2.0);
  checkMost(Limit::kPixelRays, "method.spp", pixel_rays, limits);
  checkMost(Limit::kRays, "view", pixel_rays * pixelsOf(request), limits);
}

}  // namespace saccade
