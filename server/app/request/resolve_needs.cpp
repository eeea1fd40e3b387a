#include "app/request/refusal.h"
#include "app/request/resolve.h"
#include "scene/files/text.h"

namespace saccade {
namespace {

void checkLeftOpen(const v1::Quality& quality) {
  if (quality.has_budget_ms() || quality.has_max_false_rate())
    refuse("quality.needs", "give a budget or needs, not both");
  const std::string why = "needs chooses it; leave it out";
  if (quality.has_bounces()) refuse("quality.bounces", why);
  if (quality.without_size() > 0) refuse("quality.without", why);
}

// Fills in the model in the place of the needs: sent again, the request asks for the same.
v1::ExpectedChange take(const MeasuredModel& chosen, const MeasuredModel& whole, const NeedsTable& table,
                        v1::Quality& quality) {
  quality.clear_needs();
  quality.set_bounces(static_cast<std::uint32_t>(chosen.model.bounces));
  setParts(chosen.model.without, quality);
  v1::ExpectedChange expected;
  expected.set_model(chosen.model.text());
  expected.set_changed(chosen.changed);
  expected.set_time(whole.cpu_ms > 0 ? chosen.cpu_ms / whole.cpu_ms : 1);
  expected.set_measured_on(table.settings);
  return expected;
}

}  // namespace

std::optional<v1::ExpectedChange> resolveNeeds(v1::OpenStream& request, const NeedsSource& source) {
  v1::Quality& quality = *request.mutable_quality();
  if (!quality.has_needs()) return std::nullopt;
  const std::string field = "quality.needs";
  checkRange(field, quality.needs(), kLeastNeeds, 1);
  checkLeftOpen(quality);
  if (!source.unavailable.empty()) throw Refusal(v1::CODE_UNAVAILABLE, field, source.unavailable);
  const std::vector<MeasuredModel> models = source.table.modelsOf(request.scene());
  if (models.empty()) {
    throw Refusal(v1::CODE_UNAVAILABLE, field,
                  "the scene " + request.scene() + " is not measured; measured are: " +
                      joinNames(source.table.scenes()) + "; `saccade-eval needs` measures more");
  }
  return take(cheapest(models, quality.needs()), models.front(), source.table, quality);
}

Parts resolveParts(v1::Quality& quality) {
  Parts parts;
  for (int i = 0; i < quality.without_size(); ++i) {
    const PartInfo* info = findPart(quality.without(i));
    if (!info)
      refuse("quality.without[" + std::to_string(i) + "]",
             "there is no such part; there are: " + partNames());
    parts.insert(info->part);
  }
  setParts(parts, quality);
  return parts;
}

void setParts(const Parts& parts, v1::Quality& quality) {
  quality.clear_without();
  for (const std::string& name : namesOf(parts)) quality.add_without(name);
}

}  // namespace saccade
