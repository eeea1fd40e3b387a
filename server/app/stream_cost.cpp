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
double streamMemory(int width, int height, int sensors) {
  constexpr double kFeedBytes = 260, kSensorBytes = 24;  // for a pixel
  const double pixels = (width + 2.0 * ImageF::kBorder) * (height + 2.0 * ImageF::kBorder);
  return pixels * (kFeedBytes + kSensorBytes * sensors) / (1 << 20);
}

std::vector<Share> sharesOf(const ResolvedStream& stream, const Limits& limits) {
  const int width = stream.feed.width, height = stream.feed.height;
  const int sensors = static_cast<int>(stream.sensors.size());
  return {{Limit::kStreams, 1},
          {Limit::kSensors, static_cast<double>(sensors), "sensors"},
          {Limit::kPixels, static_cast<double>(width) * height, "view"},
          {Limit::kMemory, streamMemory(width, height, sensors), "view"},
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
