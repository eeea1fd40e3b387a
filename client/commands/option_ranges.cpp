#include "client/commands/option_range.h"
#include "client/commands/request_options.h"

namespace saccade::client {

void sayRanges(CLI::App& record) {
  saySensorRanges(record);
  sayRange(record, "--turn", ranges::kTurn);
  sayRange(record, "--fov", ranges::kFovX);
  sayRange(record, "--rate", ranges::kFrameRate);
  sayRange(record, "--duration", ranges::kDuration);
  sayRange(record, "--spp", ranges::kSpp);
  sayRange(record, "--bounces", ranges::kBounces);
  sayRange(record, "--bake-error", ranges::kBakeError);
  sayRange(record, "--budget-ms", ranges::kBudget);
  sayRange(record, "--max-false-rate", ranges::kMaxFalseRate);
}

}  // namespace saccade::client
