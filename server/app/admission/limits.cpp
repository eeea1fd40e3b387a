#include "app/admission/limits.h"

#include <cmath>
#include <cstdio>

#include "base/queue_bounds.h"

namespace saccade {

constexpr double kMiB = 1 << 20;

const std::array<LimitRow, kLimits>& limitTable() {
  static const std::array<LimitRow, kLimits> rows{{
      {Limit::kStreams, "streams", 64, 1, "", "open streams"},
      {Limit::kClientStreams, "client-streams", 32, 1, "", "open streams of one client"},
      {Limit::kSensors, "sensors", 1024, 1, "", "sensors of all streams"},
      {Limit::kClientSensors, "client-sensors", 512, 1, "", "sensors of one client's streams"},
      {Limit::kPixels, "pixels", 64 << 20, 1, "", "pixels of the views of all streams"},
      {Limit::kClientPixels, "client-pixels", 32 << 20, 1, "", "pixels of the views of one client's streams"},
      {Limit::kConnections, "connections", 1024, 1, "", "connections to one socket"},
      {Limit::kClientConnections, "client-connections", 512, 1, "",
       "connections of one key, or without keys of one address, to one socket"},
      {Limit::kInbound, "inbound", 256, 16, "MiB", "incoming messages of all connections"},
      {Limit::kViewers, "viewers", 16, 1, "", "pages of browsers that watch"},
      {Limit::kRequests, "requests", 64, 1, "", "streams being opened"},
      {Limit::kClientRequests, "client-requests", 32, 1, "", "streams being opened by one client"},
      {Limit::kMemory, "memory", 4096, 1, "MiB",
       "estimated memory of all feeds, sensors, paths and requests, and of streams being opened"},
      {Limit::kQueues, "queues", 1024, 1, "MiB", "memory of packets kept for the clients of all streams"},
      {Limit::kQueue, "queue", kQueueBytes / kMiB, 0.0625, "MiB",
       "memory of packets that wait for the client of one stream"},
      {Limit::kCredit, "credit", 4096, 1, "MiB", "credit of one connection"},
      {Limit::kMessage, "message", 9, 0.0625, "MiB", "one request; a longer one ends its connection"},
      {Limit::kPictures, "pictures", 64, 1, "MiB a second",
       "pictures and descriptions of streams that all clients are given"},
      {Limit::kFrameRate, "frame-rate", ranges::kFrameRate.max, ranges::kFrameRate.min, "Hz",
       "frame rate of one stream"},
      {Limit::kTrajectoryPoints, "trajectory-points", 2e5, 1, "",
       "keyframes, or lines of CSV, of one stream"},
      {Limit::kReducedScenes, "reduced-scenes", 16, 0, "", "simplified scenes in memory"},
      {Limit::kCpu, "cpu", 85, 0, "%",
       "share of the threads for PACED streams; 0: not measured, and they may lag"},
      {Limit::kReplies, "replies", 16, 0.0625, "MiB",
       "waiting replies of one connection; with more its requests are refused"},
      {Limit::kRays, "rays", 2e9, 1, "", "rays of one frame: pixels times spp times (bounces + 2)"},
      {Limit::kPixelRays, "pixel-rays", 1e5, 1, "", "rays of one pixel: spp times (bounces + 2)"},
      {Limit::kEvents, "events", 4 << 20, 64, "",
       "events of one stream in one frame; each sensor has an equal share"},
      {Limit::kRows, "rows", 1 << 17, 1, "", "rows of the truth channels of one stream in one frame"},
      {Limit::kScenes, "scenes", 4096, 1.0 / 16, "MiB",
       "scenes in memory; unused ones are evicted for others"},
      {Limit::kBakes, "bakes", 4096, 0, "MiB", "memory of bakes in use or being made, 512 MiB for each"},
      {Limit::kBakeFiles, "bake-files", 16384, 1, "MiB",
       "files of bakes; the least recently used are removed for others"},
      {Limit::kSteers, "steers", 64, 1, "", "steers of one LOCKSTEP stream that wait for their frame"},
      {Limit::kPushes, "pushes", 4, 1, "", "frames of one stream that its client has sent and that wait"},
  }};
  return rows;
}

std::optional<Limit> ofOneClient(Limit limit) {
  switch (limit) {
    case Limit::kStreams:
      return Limit::kClientStreams;
    case Limit::kSensors:
      return Limit::kClientSensors;
    case Limit::kPixels:
      return Limit::kClientPixels;
    case Limit::kRequests:
      return Limit::kClientRequests;
    default:
      return std::nullopt;
  }
}

Limits::Limits() {
  for (const LimitRow& row : limitTable()) (*this)[row.limit] = row.fallback;
}

std::uint64_t Limits::bytes(Limit limit) const {
  return static_cast<std::uint64_t>((*this)[limit] * kMiB);
}

std::string amountText(Limit limit, double amount) {
  char text[32];
  std::snprintf(text, sizeof text, amount >= 1 ? "%.15g" : "%.3g", amount >= 1 ? std::ceil(amount) : amount);
  const std::string unit = rowOf(limit).unit;
  return unit.empty() ? text : text + (" " + unit);
}

LimitReached::LimitReached(Limit reached, std::string field, const std::string& message, double retry_s)
    : Refusal(v1::CODE_RESOURCE_EXHAUSTED, std::move(field),
              std::string("limit ") + rowOf(reached).name + ": " + message) {
  limit = rowOf(reached).name;
  retry_after_s = retry_s;
}

void describeLimits(const Limits& limits, v1::ServerDescription& description) {
  for (const LimitRow& row : limitTable()) {
    v1::LimitInfo& info = *description.add_limits();
    info.set_name(row.name);
    info.set_value(limits[row.limit]);
    info.set_unit(row.unit);
    info.set_description(row.what);
  }
}

}  // namespace saccade
