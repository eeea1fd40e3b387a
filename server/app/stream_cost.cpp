#include "app/stream_cost.h"

#include <algorithm>
#include <cmath>

#include "app/eye.h"
#include "app/refusal.h"
#include "frame/image.h"
#include "stream/credit_queue.h"

namespace saccade {
namespace {

constexpr int kMeasuredFrames = 4;       // the first of them also allocates, and is left out
constexpr double kEnoughSeconds = 0.25;  // of CPU time: slow frames need no repetition

void checkMost(Limit limit, const std::string& field, double value, const Limits& limits) {
  if (value <= limits[limit]) return;
  throw LimitReached(limit, field, amountText(limit, value) + " exceed " + amountText(limit, limits[limit]));
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

// With two digits, and not above it.
std::string atMost(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return number(std::floor(value / unit) * unit);
}

}  // namespace

// Measured on streams of 1 and 17 sensors; a sensor with all its options on takes three times the plainest.
double streamMemory(const ResolvedStream& stream) {
  constexpr double kFeedBytes = 260, kSensorBytes = 24;  // for a pixel
  constexpr double kEventBytes = 57;                     // until the events of a frame have become packets
  constexpr double kPacketBytes = 640;                   // of the packets of a frame, but for their events
  const FeedConfig& feed = stream.feed;
  const double pixels = (feed.width + 2.0 * ImageF::kBorder) * (feed.height + 2.0 * ImageF::kBorder);
  const double packets = 1 + 1e9 / kPacketTimeNs / feed.frame_rate_hz;
  double bytes = pixels * kFeedBytes;
  for (const SensorConfig& sensor : stream.sensors) {
    const double events = 1.0 * feed.width * feed.height * sensor.max_events_per_pixel_frame;
    bytes += pixels * kSensorBytes + packets * kPacketBytes +
             kEventBytes * std::min(events, static_cast<double>(sensor.max_events_per_frame));
  }
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
                         number(static_cast<double>(sensor.max_events_per_frame())) + " exceed " +
                             std::to_string(share) + " for each of the sensors");
    }
    stream.sensors[i].max_events_per_frame = sensor.max_events_per_frame();
  }
}

std::vector<Share> sharesOf(const ResolvedStream& stream, const Limits& limits) {
  const int width = stream.feed.width, height = stream.feed.height;
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
}

CpuCost measureFrame(std::shared_ptr<const RenderScene> scene, const Trajectory& path,
                     const ResolvedStream& stream, TilePool& pool) {
  Feed feed(std::move(scene), path, stream.feed, pool);
  std::vector<Eye> eyes = makeEyes(stream, {}, 0);
  const auto each = [&](const auto& f) {
    return seconds(pool.run(static_cast<int>(eyes.size()), [&](int i) { f(eyes[i]); }));
  };
  CpuCost spent, first;
  int frames = 0;
  while (frames < kMeasuredFrames && spent.feed + spent.sensors < kEnoughSeconds) {
    const IntensityChange& change = feed.step();
    spent.feed += seconds(feed.lastTimes().total());
    spent.sensors += each([&](Eye& eye) { eye.look(change); });
    if (++frames == 1) first = spent;
  }
  const double left_s = each([](Eye& eye) { eye.flush(); }) / frames;  // where frames are short, most of it
  if (frames == 1) return {first.feed, first.sensors + left_s};
  return {(spent.feed - first.feed) / (frames - 1), (spent.sensors - first.sensors) / (frames - 1) + left_s};
}

void checkPace(const v1::Timing& timing, const CpuCost& frame, double taken, double threads,
               const Limits& limits) {
  const double most = threads * limits[Limit::kCpu] / 100, free = std::max(0.0, most - taken);
  const double frame_s = frame.feed + frame.sensors;
  const double need = frame_s * timing.frame_rate_hz() * timing.speed();
  if (need <= free) return;
  const bool joins = frame.feed == 0;
  std::string message = (joins ? "in each frame its sensors take " : "a frame takes ") +
                        number(frame_s * 1e3) + " ms of CPU, so this stream takes " + number(need) +
                        " threads; " + number(free) + " of " + number(most) + " are free";
  if (free > 0 && !joins) {
    message += ": what fits is a frame rate of " + atMost(timing.frame_rate_hz() * free / need) +
               " Hz, or a speed of " + atMost(timing.speed() * free / need);
  }
  throw LimitReached(Limit::kCpu, "timing", message, need <= most ? kRetrySeconds : 0);
}

}  // namespace saccade
