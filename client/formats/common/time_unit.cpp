#include "client/formats/common/time_unit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "client/formats/common/reader.h"
#include "client/formats/common/units.h"

namespace saccade::client {
namespace {

struct UnitRow {
  const char *word, *name;
  double us;  // of one
};
constexpr std::array<UnitRow, 4> kUnits{{{"s", "seconds", 1e6},
                                         {"ms", "milliseconds", 1e3},
                                         {"us", "microseconds", 1},
                                         {"ns", "nanoseconds", 1e-3}}};
constexpr double kMaxUs = static_cast<double>(INT64_MAX / kNsPerUs);
// Until the year 2286: larger numbers are likely of a finer unit.
constexpr double kLikelySeconds = 1e10, kLikelyUs = 1e16;

const UnitRow& rowOf(TimeUnit unit) {
  return kUnits[static_cast<std::size_t>(unit)];
}

[[noreturn]] void refuse(const std::string& path, const char* seen, TimeUnit a, TimeUnit b) {
  throw FileFault(path, std::string("t has ") + seen + "; it may count " + rowOf(a).name + " or " +
                            rowOf(b).name + ": give --unit " + rowOf(a).word + " or --unit " + rowOf(b).word);
}

}  // namespace

std::optional<TimeUnit> parseTimeUnit(std::string_view word) {
  const auto row =
      std::find_if(kUnits.begin(), kUnits.end(), [&](const UnitRow& r) { return word == r.word; });
  if (row == kUnits.end()) return std::nullopt;
  return static_cast<TimeUnit>(row - kUnits.begin());
}

std::optional<std::int64_t> toUs(std::int64_t time, TimeUnit unit) {
  if (unit == TimeUnit::kNs) return time / kNsPerUs + (time % kNsPerUs + 1500) / kNsPerUs - 1;
  const auto factor = static_cast<std::int64_t>(rowOf(unit).us);
  std::int64_t us;
  if (__builtin_mul_overflow(time, factor, &us)) return std::nullopt;
  return us;
}

std::optional<std::int64_t> toUs(double time, TimeUnit unit) {
  const double us = unit == TimeUnit::kNs ? time / 1e3 : time * rowOf(unit).us;
  if (!(std::abs(us) < kMaxUs)) return std::nullopt;
  return std::llround(us);
}

void TimesSeen::add(double time) {
  fraction = fraction || time != std::trunc(time);
  largest = std::max(largest, std::abs(time));
}

FoundUnit findUnit(const std::string& path, std::optional<TimeUnit> given, std::optional<TimeUnit> told,
                   const TimesSeen& seen) {
  if (given) return {*given, rowOf(*given).name + std::string(" (--unit)")};
  if (told) return {*told, ""};
  if (seen.decimal && seen.largest > kLikelySeconds)
    refuse(path, "a decimal point and numbers above 10000000000", TimeUnit::kUs, TimeUnit::kNs);
  if (seen.decimal && !seen.fraction && seen.largest > 0)
    refuse(path, "a decimal point, but only whole numbers", TimeUnit::kS, TimeUnit::kUs);
  if (seen.decimal) return {TimeUnit::kS, "seconds (it has a decimal point)"};
  if (seen.largest > kLikelyUs)
    refuse(path, "whole numbers above 10000000000000000", TimeUnit::kUs, TimeUnit::kNs);
  return {TimeUnit::kUs, "microseconds (it has whole numbers)"};
}

}  // namespace saccade::client
