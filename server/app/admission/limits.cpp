#include "app/admission/limits.h"

#include <cmath>
#include <cstdio>

#include "base/mebibyte.h"

namespace saccade {

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
  for (const LimitRow& row : kLimitTable) (*this)[row.limit] = row.fallback;
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
  for (const LimitRow& row : kLimitTable) {
    v1::LimitInfo& info = *description.add_limits();
    info.set_name(row.name);
    info.set_value(limits[row.limit]);
    info.set_unit(row.unit);
    info.set_description(row.what);
  }
}

}  // namespace saccade
