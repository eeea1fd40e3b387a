#include <algorithm>
#include <limits>

#include "app/request/refusal.h"
#include "app/request/resolve_objects.h"
#include "app/request/resolve_quality.h"

namespace saccade {
namespace {

// Returns the field of the budget that is set.
std::string checkBudget(const v1::Quality& quality) {
  if (quality.has_budget_ms() && quality.has_max_false_rate()) {
    refuse("quality.max_false_rate", "give budget_ms or max_false_rate, not both");
  }
  if (quality.has_budget_ms()) {
    checkRange("quality.budget_ms", quality.budget_ms(), ranges::kBudget);
    return "quality.budget_ms";
  }
  checkRange("quality.max_false_rate", quality.max_false_rate(), ranges::kMaxFalseRate);
  return "quality.max_false_rate";
}

void checkLeftOpen(const v1::Method& method) {
  const std::string why = "a budget chooses it; leave it out";
  if (method.spp() != 0) refuse("method.spp", why);
  if (!method.params().empty()) refuse("method.params", why);
}

double framesOf(const v1::Timing& timing) {
  if (timing.duration_s() == 0) return std::numeric_limits<double>::infinity();
  return timing.duration_s() * timing.frame_rate_hz();
}

SettingsQuery queryOf(const v1::OpenStream& request, const std::vector<SensorConfig>& sensors) {
  double threshold = std::numeric_limits<double>::infinity();
  for (const SensorConfig& s : sensors) threshold = std::min({threshold, s.threshold, s.threshold_off});
  double pixels = static_cast<double>(request.view().width()) * request.view().height();
  for (const v1::View& view : request.further_views())
    pixels += static_cast<double>(view.width()) * view.height();
  return {request.scene(), pixels, threshold, request.method().name(), framesOf(request.timing())};
}

MeasuredSetting choose(const v1::Quality& quality, const std::vector<MeasuredSetting>& settings) {
  return quality.has_budget_ms() ? mostAccurate(settings, quality.budget_ms())
                                 : fastest(settings, quality.max_false_rate());
}

// Replaces the budget by the setting it chose: the request, sent again, asks for the same.
v1::ExpectedQuality take(const MeasuredSetting& setting, const AccuracyTable& table,
                         v1::OpenStream& request) {
  v1::Quality& quality = *request.mutable_quality();
  quality.clear_budget_ms(), quality.clear_max_false_rate();
  quality.set_bounces(static_cast<std::uint32_t>(table.bounces));
  v1::Method& method = *request.mutable_method();
  method.set_name(setting.method.name);
  method.set_spp(static_cast<std::uint32_t>(setting.spp));
  method.mutable_params()->insert(setting.method.params.begin(), setting.method.params.end());
  v1::ExpectedQuality expected;
  expected.set_setting(setting.method.text);
  expected.set_cpu_ms(setting.cpu_ms);
  expected.set_false_rate(setting.false_events);
  expected.set_missed_rate(setting.missed_events);
  expected.set_measured_on(table.settings);
  return expected;
}

}  // namespace

std::optional<v1::ExpectedQuality> resolveBudget(v1::OpenStream& request,
                                                 const std::vector<SensorConfig>& sensors,
                                                 const AccuracySource& accuracy) {
  const v1::Quality& quality = request.quality();
  if (!quality.has_budget_ms() && !quality.has_max_false_rate()) return std::nullopt;
  const std::string field = checkBudget(quality);
  checkLeftOpen(request.method());
  if (!accuracy.unavailable.empty()) throw Refusal(v1::CODE_UNAVAILABLE, field, accuracy.unavailable);
  if (!bodyNames(request).empty())
    throw Refusal(v1::CODE_UNAVAILABLE, field, "no scene is measured with moving objects");
  const AccuracyTable& table = accuracy.table;
  if (quality.has_bounces() && static_cast<int>(quality.bounces()) != table.bounces) {
    refuse("quality.bounces",
           "budgets are answered for " + std::to_string(table.bounces) + " bounces; leave it out");
  }
  try {
    return take(choose(quality, settingsFor(table, queryOf(request, sensors))), table, request);
  } catch (const NotMeasured& fault) {
    throw Refusal(v1::CODE_UNAVAILABLE, field,
                  std::string(fault.what()) + "; `saccade-eval chart` measures more");
  } catch (const NothingFits& fault) {
    refuse(field, fault.what());
  }
}

}  // namespace saccade
