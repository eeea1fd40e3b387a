#include "events/time_order.h"

#include <array>
#include <bit>

namespace saccade {
namespace {

constexpr int kDigitBits = 11;
constexpr std::uint64_t kDigits = 1 << kDigitBits;

std::uint64_t ticks(TimeNs t) {
  return static_cast<std::uint64_t>(t.count()) / kEventTimeUnit.count();
}

}  // namespace

void TimeOrder::sort(Events& events, const Interval& interval) {
  scratch_.resize(events.size());
  const int bits = std::bit_width(ticks(interval.t1 - interval.t0) - 1);
  for (int shift = 0; shift < bits; shift += kDigitBits) {
    const auto digit = [&](const Event& e) {
      return ticks(TimeNs(e.t_ns) - interval.t0) >> shift & (kDigits - 1);
    };
    // Where the events of each digit begin.
    std::array<std::uint32_t, kDigits + 1> begin{};
    for (const Event& e : events) ++begin[digit(e) + 1];
    for (std::size_t i = 0; i < kDigits; ++i) begin[i + 1] += begin[i];
    for (const Event& e : events) scratch_[begin[digit(e)]++] = e;
    events.swap(scratch_);
  }
  giveBackSlack(scratch_);
}

}  // namespace saccade
