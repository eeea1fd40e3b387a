#include <cmath>

#include "client/options/option_range.h"
#include "client/options/request_options.h"

namespace saccade::client {

std::string rangeFault(const std::string& text, double min, double max, bool whole) {
  const auto value = parseNumber<double>(text);
  if (!value) return "'" + text + "' is not a number";
  std::ostringstream fault;
  if (!(*value >= min && *value <= max)) {
    fault << text << " is outside [" << min << ", " << max << "]";
  } else if (whole && *value != std::trunc(*value)) {
    fault << text << " is not a whole number";
  }
  return fault.str();
}

void limitRequest(CLI::App& command) {
  limitSensors(command);
  limitTo(command, "--turn", ranges::kTurn, "0");
  limitTo(command, "--clearance", ranges::kClearance);
  limitTo(command, "--fov", ranges::kFovX);
  limitTo(command, "--metres-per-unit", ranges::kMetresPerUnit);
  limitTo(command, "--pose-rate", ranges::kFrameRate);
  limitTo(command, "--rate", ranges::kFrameRate);
  limitTo(command, "--interval-px", ranges::kIntervalPx);
  limitTo(command, "--finest-px", ranges::kFinestPx);
  limitTo(command, "--min-rate", ranges::kFrameRate);
  limitTo(command, "--max-rate", ranges::kFrameRate);
  limitTo(command, "--duration", ranges::kDuration);
  limitTo(command, "--retry-time", Range<double>{0, 1e6});
  limitTo(command, "--spp", ranges::kSpp);
  limitTo(command, "--bounces", ranges::kBounces);
  limitTo(command, "--bake-error", ranges::kBakeError);
  limitTo(command, "--budget-ms", ranges::kBudget);
  limitTo(command, "--max-false-rate", ranges::kMaxFalseRate);
}

}  // namespace saccade::client
