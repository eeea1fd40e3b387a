// What the server bounds, for all and for each client: the one table of it.
//
// A client is its public key. Without keys nobody can tell clients apart: then those of one client bind
// nothing.
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
  kScenes,
};
inline constexpr std::size_t kLimits = static_cast<std::size_t>(Limit::kScenes) + 1;

struct LimitRow {
  Limit limit;
  const char* name;  // on the wire; the option is --limit-<name>
  double fallback, min;
  const char* unit;  // empty: a number of things
  const char* what;
};

const std::array<LimitRow, kLimits>& limitTable();  // in the order of Limit
inline const LimitRow& rowOf(Limit limit) {
  return limitTable()[static_cast<std::size_t>(limit)];
}

// That of one client beside one for all; most have none.
std::optional<Limit> ofOneClient(Limit limit);

// A value for each.
class Limits {
 public:
  Limits();  // the defaults
  double& operator[](Limit limit) { return values_[static_cast<std::size_t>(limit)]; }
  double operator[](Limit limit) const { return values_[static_cast<std::size_t>(limit)]; }
  std::uint64_t bytes(Limit limit) const;  // of one in MiB
  friend bool operator==(const Limits&, const Limits&) = default;

 private:
  std::array<double, kLimits> values_;
};

// A number with the unit of the limit, for people.
std::string amountText(Limit limit, double amount);

// Others who hold what is wanted end when they like.
inline constexpr double kRetrySeconds = 2;

struct LimitReached : Refusal {
  // `retry_after_s` as in Status.
  LimitReached(Limit limit, std::string field, const std::string& message, double retry_after_s = 0);
};

void describeLimits(const Limits& limits, v1::ServerDescription& description);

}  // namespace saccade
