// The table of the server's limits, some for all clients together and some for each client.
//
// A client is a public key. Without keys clients cannot be told apart, and the limits of one client bind
// nobody.
#pragma once

#include <array>
#include <optional>

#include "app/request/refusal.h"
#include "base/mebibyte.h"
#include "base/queue_bounds.h"
#include "saccade/v1/control.pb.h"
#include "saccade/wire/ranges.h"

namespace saccade {

enum class Limit {
  kStreams,
  kClientStreams,
  kSensors,
  kClientSensors,
  kPixels,
  kClientPixels,
  kConnections,
  kClientConnections,
  kInbound,
  kViewers,
  kRequests,
  kClientRequests,
  kMemory,
  kQueues,
  kQueue,
  kCredit,
  kMessage,
  kPictures,
  kFrameRate,
  kTrajectoryPoints,
  kReducedScenes,
  kCpu,
  kReplies,
  kRays,
  kPixelRays,
  kEvents,
  kRows,
  kScenes,
  kBakes,
  kBakeFiles,
  kSteers,
  kPushes,
};
inline constexpr std::size_t kLimits = static_cast<std::size_t>(Limit::kPushes) + 1;

struct LimitRow {
  Limit limit;
  const char* name;  // on the wire; the option is --limit-<name>
  double fallback, min;
  const char* unit;  // empty: a count
  const char* what;  // for people
};

// In the order of Limit.
inline constexpr std::array<LimitRow, kLimits> kLimitTable{{
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
    {Limit::kViewers, "viewers", 64, 1, "", "pages of browsers that watch"},
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
    {Limit::kTrajectoryPoints, "trajectory-points", 2e5, 1, "", "keyframes, or lines of CSV, of one stream"},
    {Limit::kReducedScenes, "reduced-scenes", 16, 0, "",
     "scenes in memory that are simplified, or have objects that move"},
    {Limit::kCpu, "cpu", 85, 0, "%",
     "share of the threads for PACED streams; 0: not measured, and they may lag"},
    {Limit::kReplies, "replies", 16, 0.0625, "MiB",
     "waiting replies of one connection; with more its requests are refused"},
    {Limit::kRays, "rays", 2e9, 1, "", "rays of one frame: pixels times spp times (bounces + 2)"},
    {Limit::kPixelRays, "pixel-rays", 1e5, 1, "", "rays of one pixel: spp times (bounces + 2)"},
    {Limit::kEvents, "events", 4 << 20, 64, "",
     "events of one stream in one frame; each sensor has an equal share"},
    {Limit::kRows, "rows", 1 << 17, 1, "", "rows of the truth channels of one stream in one frame"},
    {Limit::kScenes, "scenes", 4096, 1.0 / 16, "MiB", "scenes in memory; unused ones are evicted for others"},
    {Limit::kBakes, "bakes", 4096, 0, "MiB", "memory of bakes in use or being made, 512 MiB for each"},
    {Limit::kBakeFiles, "bake-files", 16384, 1, "MiB",
     "files of bakes; the least recently used are removed for others"},
    {Limit::kSteers, "steers", 64, 1, "", "steers of one LOCKSTEP stream that wait for their frame"},
    {Limit::kPushes, "pushes", 4, 1, "", "frames of one stream that its client has sent and that wait"},
}};
inline const LimitRow& rowOf(Limit limit) {
  return kLimitTable[static_cast<std::size_t>(limit)];
}

// The limit of one client that belongs to a limit of all; most have none.
std::optional<Limit> ofOneClient(Limit limit);

// The value of each limit.
class Limits {
 public:
  Limits();  // the defaults
  double& operator[](Limit limit) { return values_[static_cast<std::size_t>(limit)]; }
  double operator[](Limit limit) const { return values_[static_cast<std::size_t>(limit)]; }
  std::uint64_t bytes(Limit limit) const;  // of a limit in MiB
  friend bool operator==(const Limits&, const Limits&) = default;

 private:
  std::array<double, kLimits> values_;
};

// An amount with the unit of the limit, for people; above 1 it is rounded up.
std::string amountText(Limit limit, double amount);

// Suggested retry delay when other clients hold the limit: nobody knows when they end.
inline constexpr double kRetrySeconds = 2;

// CODE_RESOURCE_EXHAUSTED: "limit NAME: message". `retry_after_s` as in Status.
struct LimitReached : Refusal {
  LimitReached(Limit limit, std::string field, const std::string& message, double retry_after_s = 0);
};

void describeLimits(const Limits& limits, v1::ServerDescription& description);

}  // namespace saccade
