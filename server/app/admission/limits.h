// The table of the server's limits, some for all clients together and some for each client.
//
// A client is a public key. Without keys clients cannot be told apart, and the limits of one client bind
// nobody.
#pragma once

#include <array>
#include <optional>

#include "app/request/refusal.h"
#include "saccade/v1/control.pb.h"

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

const std::array<LimitRow, kLimits>& limitTable();  // in the order of Limit
inline const LimitRow& rowOf(Limit limit) {
  return limitTable()[static_cast<std::size_t>(limit)];
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
