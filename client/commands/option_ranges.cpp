#include <sstream>

#include "client/commands/request_options.h"
#include "wire/ranges.h"

namespace saccade::client {

void sayRanges(CLI::App& record) {
  const auto say = [&](const char* name, auto range) {
    CLI::Option* option = record.get_option(name);
    std::ostringstream text;
    text << option->get_description() << "; [" << range.min << ", " << range.max << "]";
    option->description(text.str());
  };
  say("--turn", ranges::kTurn);
  say("--threshold", ranges::kThreshold);
  say("--threshold-off", ranges::kThreshold);
  say("--bias", ranges::kBias);
  say("--refractory", ranges::kRefractory);
  say("--cutoff", ranges::kCutoff);
  say("--fov", ranges::kFovX);
  say("--rate", ranges::kFrameRate);
  say("--duration", ranges::kDuration);
  say("--spp", ranges::kSpp);
  say("--bounces", ranges::kBounces);
  say("--bake-error", ranges::kBakeError);
  say("--budget-ms", ranges::kBudget);
  say("--max-false-rate", ranges::kMaxFalseRate);
}

}  // namespace saccade::client
