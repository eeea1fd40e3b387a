#include "tables/time_model.h"

#include <algorithm>
#include <cmath>

namespace saccade {
namespace {

constexpr double kSmall = 0.25;  // the pixels of small_ms

// Noise may leave a fixed part below 0, or above the whole.
double fixedPart(const MeasuredTime& t) {
  if (std::isnan(t.small_ms)) return 0;
  return std::clamp((t.small_ms - kSmall * t.first_ms) / (1 - kSmall), 0.0, t.first_ms);
}

double lateShare(const MeasuredTime& t) {
  return t.small_late_ms > 0 && t.small_ms > 0 ? t.small_late_ms / t.small_ms : 1;
}

}  // namespace

double timeAt(const MeasuredTime& measured, double pixels, double length) {
  const double fixed = fixedPart(measured), late = lateShare(measured);
  return (fixed + (measured.first_ms - fixed) * pixels) * (late + (1 - late) / std::max(length, 1.0));
}

}  // namespace saccade
