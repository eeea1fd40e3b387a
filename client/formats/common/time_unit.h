// The unit of times in files that others write, and how it is found where a file does not tell it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace saccade::client {

enum class TimeUnit { kS, kMs, kUs, kNs };

inline constexpr const char* kTimeUnits = "s, ms, us, ns";
// The unit of one of these words.
std::optional<TimeUnit> parseTimeUnit(std::string_view word);

// The whole microseconds nearest to a time; nullopt: beyond 292 years, as NaN is.
std::optional<std::int64_t> toUs(std::int64_t time, TimeUnit unit);
std::optional<std::int64_t> toUs(double time, TimeUnit unit);

// Signs of the unit in the first times of a file.
struct TimesSeen {
  void add(double time);

  bool decimal = false;   // they are written with a decimal point, or are floating-point numbers
  bool fraction = false;  // one of them is not whole
  double largest = 0;     // of their magnitudes
};

struct FoundUnit {
  TimeUnit unit = TimeUnit::kUs;
  std::string why;  // "microseconds (whole numbers)"; empty: the file tells it
};

// `given`: --unit; `told`: by the file, as in the name t_us. Without both, whole numbers count microseconds,
// and numbers with fractions count seconds. Throws FileFault with both readings if neither is likely.
FoundUnit findUnit(const std::string& path, std::optional<TimeUnit> given, std::optional<TimeUnit> told,
                   const TimesSeen& seen);

}  // namespace saccade::client
