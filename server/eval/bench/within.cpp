#include "eval/bench/within.h"

#include <charconv>
#include <cmath>
#include <sstream>
#include <string_view>

namespace saccade::eval {
namespace {

// The number before `unit`, or none.
std::optional<double> amount(std::string_view text, std::string_view unit) {
  if (!text.ends_with(unit)) return std::nullopt;
  text.remove_suffix(unit.size());
  double value = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && rest == text.data() + text.size();
  return whole && std::isfinite(value) && value >= 0 ? std::optional(value) : std::nullopt;
}

std::string answerFor(const std::vector<MeasuredSetting>& settings, const Within& within) {
  std::ostringstream line;
  line.precision(3);
  try {
    const MeasuredSetting s = within.budget_ms ? mostAccurate(settings, *within.budget_ms)
                                               : fastest(settings, within.max_false_rate.value());
    line << s.text() << ": " << s.cpu_ms << " ms, " << s.false_events << " false and " << s.missed_events
         << " missed events per pixel-frame";
  } catch (const NothingFits& nearest) {
    line << "nothing; " << nearest.what();
  }
  return line.str();
}

}  // namespace

Within parseWithin(const std::string& text) {
  const auto ms = amount(text, "ms"), percent = amount(text, "%");
  if (ms) return {.budget_ms = *ms, .max_false_rate = {}};
  if (percent) return {.budget_ms = {}, .max_false_rate = *percent / 100};
  throw std::runtime_error("\"" + text +
                           "\" is neither CPU milliseconds per frame, such as 20ms, nor false events per "
                           "pixel-frame in percent, such as 2%");
}

std::string answerWithin(const AccuracyTable& table, const Within& within) {
  std::ostringstream text;
  for (const std::string& scene : table.scenes()) {
    const double pixels = static_cast<double>(table.width) * table.height;
    text << scene << ": " << answerFor(settingsFor(table, {scene, pixels, table.threshold, {}, 0}), within)
         << '\n';
  }
  return text.str();
}

}  // namespace saccade::eval
